//! One smoothed level of the multigrid: plain data and the steps of the cycle.

use crate::chebyshev::Chebyshev;
use crate::csr::Csr;
use crate::entry::Entry;
use crate::gauss_seidel::{Order, sweep};
use crate::kernels::{add_product, product, residual};
use crate::options::{MultigridOptions, Smoother};

/// The estimated largest eigenvalue is from below; the damped interval ends
/// this much higher.
const SAFETY: f64 = 1.1;

/// A matrix, its smoother, the transfer to the next coarser level and the work
/// vectors of both, allocated once.
pub(crate) struct Level<E: Entry> {
    matrix: Csr<E>,
    inverse_diagonal: Vec<E>,
    /// `None` for Gauss–Seidel, which has no data of its own.
    chebyshev: Option<Chebyshev<E>>,
    before: usize,
    after: usize,
    prolongation: Csr<E::Real>,
    restriction: Csr<E::Real>,
    residual: Vec<E::Nodal>,
    /// Right-hand side and solution of the next coarser level.
    pub(crate) coarse_rhs: Vec<E::Nodal>,
    pub(crate) coarse_x: Vec<E::Nodal>,
}

impl<E: Entry> Level<E> {
    /// A level of `scale` times a matrix in double precision with the inverses of
    /// its diagonal; `eigenvalue` is the estimate for D⁻¹A, which no scale changes.
    pub(crate) fn new<D: Entry>(
        (matrix, inverse_diagonal, scale): (&Csr<D>, &[D], f64),
        eigenvalue: f64,
        (prolongation, restriction): (&Csr<f64>, &Csr<f64>),
        options: &MultigridOptions,
    ) -> Self {
        let chebyshev = match options.smoother {
            Smoother::Chebyshev { degree, lower } => {
                let upper = SAFETY * eigenvalue;
                Some(Chebyshev::new(matrix.rows(), degree, lower * upper, upper))
            }
            Smoother::GaussSeidel => None,
        };
        Self {
            matrix: matrix.cast_scaled(scale),
            inverse_diagonal: inverse_diagonal.iter().map(|d| d.cast_scaled(1.0 / scale)).collect(),
            chebyshev,
            before: options.before,
            after: options.after,
            prolongation: prolongation.cast(),
            restriction: restriction.cast(),
            residual: vec![E::Nodal::default(); matrix.rows()],
            coarse_rhs: vec![E::Nodal::default(); prolongation.columns()],
            coarse_x: vec![E::Nodal::default(); prolongation.columns()],
        }
    }

    /// x = what the sweeps before the correction make of zero.
    pub(crate) fn smooth_before(&mut self, b: &[E::Nodal], x: &mut Vec<E::Nodal>) {
        if self.before == 0 || self.chebyshev.is_none() {
            x.fill(E::Nodal::default());
        }
        self.smooth(self.before, Order::Forward, b, x, true);
    }

    /// The sweeps after the correction.
    pub(crate) fn smooth_after(&mut self, b: &[E::Nodal], x: &mut Vec<E::Nodal>) {
        self.smooth(self.after, Order::Backward, b, x, false);
    }

    fn smooth(
        &mut self,
        sweeps: usize,
        order: Order,
        b: &[E::Nodal],
        x: &mut Vec<E::Nodal>,
        from_zero: bool,
    ) {
        for k in 0..sweeps {
            match &mut self.chebyshev {
                Some(chebyshev) => {
                    let from_zero = from_zero && k == 0;
                    chebyshev.smooth(&self.matrix, &self.inverse_diagonal, (b, x), from_zero);
                }
                None => sweep(&self.matrix, &self.inverse_diagonal, b, x, order),
            }
        }
    }

    /// The coarse right-hand side: Pᵀ (b − A x).
    pub(crate) fn restrict_residual(&mut self, b: &[E::Nodal], x: &[E::Nodal]) {
        residual(&self.matrix, x, b, &mut self.residual);
        product(&self.restriction, &self.residual, &mut self.coarse_rhs);
    }

    /// x += P times the coarse solution.
    pub(crate) fn correct(&self, x: &mut [E::Nodal]) {
        add_product(&self.prolongation, &self.coarse_x, x);
    }

    /// The memory of matrices and work vectors, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let transfers = self.prolongation.bytes() + self.restriction.bytes();
        let vectors = [&self.residual, &self.coarse_rhs, &self.coarse_x];
        self.matrix.bytes()
            + size_of_val(&*self.inverse_diagonal)
            + transfers
            + vectors.iter().map(|v| size_of_val(v.as_slice())).sum::<usize>()
            + self.chebyshev.as_ref().map_or(0, Chebyshev::bytes)
    }
}
