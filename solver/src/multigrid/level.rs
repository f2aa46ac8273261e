//! One smoothed level of the multigrid: plain data and the steps of the cycle.

use crate::multigrid::galerkin::constrained_galerkin;
use crate::multigrid::options::ResolvedOptions;
use crate::multigrid::projectors::{Projectors, project};
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::multigrid::smoother::level_smoother::{Grouping, LevelSmoother};
use crate::multigrid::weights::Weights;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::kernels::product;
use crate::sparse::pattern::Pattern;
use octruss_base::large_array::zeroed;
use std::sync::Arc;

/// A matrix with its smoother, the transfer to the next coarser level and the work
/// vectors of both, allocated once.
pub(crate) struct Level<E: Entry> {
    pub(crate) smoothing: LevelSmoother<E>,
    pub(crate) before: usize,
    pub(crate) after: usize,
    pub(crate) prolongation: Weights<E>,
    pub(crate) restriction: Weights<E>,
    /// The constrained rows of this and of the next coarser level.
    projectors: Vec<(u32, E)>,
    coarse_projectors: Vec<(u32, E)>,
    residual: Vec<E::Nodal>,
    /// Right-hand side and solution of the next coarser level.
    pub(crate) coarse_rhs: Vec<E::Nodal>,
    pub(crate) coarse_x: Vec<E::Nodal>,
}

/// What a level keeps when the numbers of its matrix change.
pub(crate) struct Kept<E: Entry> {
    pub(crate) prolongation: Weights<E>,
    pub(crate) restriction: Weights<E>,
    /// How the rows are grouped for the smoother, if known.
    pub(crate) grouping: Option<Grouping>,
}

impl<E: Entry> Kept<E> {
    /// From a prolongation in the precision of a cycle.
    pub(crate) fn new(prolongation: Weights<E>) -> Self {
        Self { restriction: prolongation.transposed(), prolongation, grouping: None }
    }

    /// The Galerkin product of a prolongation of numbers, see
    /// [`constrained_galerkin`]; none of another.
    pub(crate) fn galerkin<D: Entry<Real = f64>>(
        &self,
        matrix: (&Csr<D>, &Projectors<D>),
        coarse: &Projectors<D>,
        known: Option<&Arc<Pattern>>,
    ) -> Option<Csr<D>> {
        match (&self.prolongation, &self.restriction) {
            (Weights::Numbers(p), Weights::Numbers(transposed)) => {
                Some(constrained_galerkin(matrix, (p, transposed), coarse, known))
            }
            _ => None,
        }
    }
}

impl<E: Entry> Level<E> {
    /// A level of `scale` times a matrix in double precision.
    pub(crate) fn new<D: Entry<Real = f64>>(
        (matrix, diagonal, scale): (&Csr<D>, Diagonal<D>, f64),
        Kept { prolongation, restriction, grouping }: Kept<E>,
        [fine, coarse]: [&Projectors<D>; 2],
        options: &ResolvedOptions,
    ) -> Self {
        Self {
            smoothing: LevelSmoother::new((matrix, diagonal, scale), fine, options, grouping),
            before: options.before,
            after: options.after,
            projectors: fine.cast(),
            coarse_projectors: coarse.cast(),
            residual: zeroed(matrix.rows()),
            coarse_rhs: zeroed(prolongation.columns()),
            coarse_x: zeroed(prolongation.columns()),
            prolongation,
            restriction,
        }
    }

    /// What another matrix with the same pattern can use.
    pub(crate) fn into_kept(self) -> Kept<E> {
        let Self { prolongation, restriction, smoothing, .. } = self;
        Kept { prolongation, restriction, grouping: smoothing.into_grouping() }
    }

    /// The sweeps before the correction; with `from_zero` what they make of zero,
    /// whatever `x` holds.
    pub(crate) fn smooth_before(&mut self, b: &[E::Nodal], x: &mut Vec<E::Nodal>, from_zero: bool) {
        self.smoothing.before(self.before, (b, x), from_zero, &mut self.residual);
    }

    /// The residual b − A x after [`Level::smooth_before`], and only then: some
    /// smoothers left it.
    pub(crate) fn compute_residual(&mut self, b: &[E::Nodal], x: &[E::Nodal]) {
        self.smoothing.residual(b, x, &mut self.residual);
    }

    /// The sweeps after the correction.
    pub(crate) fn smooth_after(&mut self, b: &[E::Nodal], x: &mut Vec<E::Nodal>) {
        self.smoothing.after(self.after, b, x);
    }

    /// The coarse right-hand side: Pᵀ times the residual.
    pub(crate) fn restrict_residual(&mut self) {
        self.restriction.product(&self.residual, &mut self.coarse_rhs);
        project(&self.coarse_projectors, &mut self.coarse_rhs);
    }

    /// Pᵀ b, for a right-hand side.
    pub(crate) fn restrict(&self, b: &[E::Nodal]) -> Vec<E::Nodal> {
        let mut coarse = vec![E::Nodal::default(); self.restriction.rows()];
        self.restriction.product(b, &mut coarse);
        project(&self.coarse_projectors, &mut coarse);
        coarse
    }

    /// x += P times the coarse solution.
    pub(crate) fn correct(&self, x: &mut [E::Nodal]) {
        self.prolongation.add_product(&self.coarse_x, x);
        project(&self.projectors, x);
    }

    /// A coarse solution on this level, by another matrix than P or by P.
    pub(crate) fn transfer(&self, matrix: Option<&Csr<f64>>, coarse: &[E::Nodal]) -> Vec<E::Nodal> {
        let mut x = vec![E::Nodal::default(); self.prolongation.rows()];
        match matrix {
            Some(matrix) => product(&matrix.cast::<E::Real>(), coarse, &mut x),
            None => self.prolongation.product(coarse, &mut x),
        }
        project(&self.projectors, &mut x);
        x
    }

    /// The memory of matrices and work vectors, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let transfers = self.prolongation.bytes() + self.restriction.bytes();
        let vectors = [&self.residual, &self.coarse_rhs, &self.coarse_x];
        self.smoothing.bytes()
            + transfers
            + vectors.iter().map(|v| size_of_val(v.as_slice())).sum::<usize>()
    }
}
