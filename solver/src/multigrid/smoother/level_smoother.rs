//! The smoother of one level, whichever it is, with the matrix in the form it needs.

use crate::multigrid::options::{ResolvedOptions, Smoother};
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoother::colouring::Colouring;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::multigrid::smoother::domains::Domains;
use crate::multigrid::smoother::gauss_seidel::Order;
use crate::multigrid::smoother::hybrid_gauss_seidel::HybridGaussSeidel;
use crate::multigrid::smoother::row_smoother::RowSmoother;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;

/// A level's matrix and its smoother, with its data and work vectors.
pub(crate) enum LevelSmoother<E: Entry> {
    Rows(RowSmoother<E>),
    Hybrid(HybridGaussSeidel<E>),
}

/// How the rows of a matrix are grouped, which depends on its pattern alone.
pub(crate) enum Grouping {
    Colours(Colouring),
    Domains(Domains),
}

impl<E: Entry> LevelSmoother<E> {
    /// The smoother of `scale` times a matrix, in the cycle's precision. How its rows are
    /// grouped may be known; without domains all rows are one.
    pub(crate) fn new<D: Entry<Real = f64>>(
        (matrix, diagonal, scale): (&Csr<D>, Diagonal<D>, f64),
        projectors: &Projectors<D>,
        options: &ResolvedOptions,
        known: Option<Grouping>,
    ) -> Self {
        let (diagonal_kind, scaled) = (options.diagonal, |diagonal| (matrix, diagonal, scale));
        Self::Rows(match (options.smoother, known) {
            (Smoother::HybridGaussSeidel, Some(Grouping::Domains(domains))) => {
                return Self::Hybrid(HybridGaussSeidel::new((matrix, &diagonal, scale), domains));
            }
            (Smoother::HybridGaussSeidel | Smoother::GaussSeidel, _) => {
                RowSmoother::gauss_seidel(scaled(diagonal))
            }
            (Smoother::Chebyshev { degree, lower }, _) => {
                let diagonal = diagonal.of_kind(diagonal_kind, projectors);
                RowSmoother::chebyshev(scaled(diagonal), (degree, lower))
            }
            (Smoother::L1Jacobi, _) => {
                let diagonal = diagonal.plus_rows(matrix, diagonal_kind, projectors);
                RowSmoother::jacobi(scaled(diagonal))
            }
            (Smoother::ColouredGaussSeidel, known) => {
                let colours = match known {
                    Some(Grouping::Colours(colours)) => Some(colours),
                    _ => None,
                };
                RowSmoother::coloured(scaled(diagonal), colours)
            }
        })
    }

    /// How the rows are grouped, if they are.
    pub(crate) fn into_grouping(self) -> Option<Grouping> {
        match self {
            Self::Rows(rows) => rows.into_colouring().map(Grouping::Colours),
            Self::Hybrid(hybrid) => Some(Grouping::Domains(hybrid.into_domains())),
        }
    }

    /// The sweeps before the correction; with `from_zero` from zero, whatever `x` holds.
    /// Some leave the residual in `r`.
    pub(crate) fn before(
        &mut self,
        sweeps: usize,
        (b, x): (&[E::Nodal], &mut Vec<E::Nodal>),
        from_zero: bool,
        r: &mut [E::Nodal],
    ) {
        match self {
            Self::Rows(rows) => {
                if from_zero && sweeps == 0 {
                    x.fill(E::Nodal::default());
                }
                for sweep in 0..sweeps {
                    rows.sweep((b, x), Order::Forward, from_zero && sweep == 0);
                }
            }
            Self::Hybrid(hybrid) => hybrid.before(sweeps, (b, x), from_zero, r),
        }
    }

    /// The residual after these sweeps, unless they left it.
    pub(crate) fn residual(&self, b: &[E::Nodal], x: &[E::Nodal], r: &mut [E::Nodal]) {
        match self {
            Self::Rows(rows) => rows.residual(b, x, r),
            Self::Hybrid(_) => {}
        }
    }

    /// The sweeps after the correction.
    pub(crate) fn after(&mut self, sweeps: usize, b: &[E::Nodal], x: &mut Vec<E::Nodal>) {
        match self {
            Self::Rows(rows) => {
                for _ in 0..sweeps {
                    rows.sweep((b, x), Order::Backward, false);
                }
            }
            Self::Hybrid(hybrid) => hybrid.after(sweeps, b, x),
        }
    }

    /// The estimated largest eigenvalue of D⁻¹A, where the smoother needs one.
    pub(crate) fn largest_eigenvalue(&self) -> Option<f64> {
        match self {
            Self::Rows(rows) => rows.largest_eigenvalue,
            Self::Hybrid(_) => None,
        }
    }

    /// The memory of the matrix, its smoother's data and work vectors, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        match self {
            Self::Rows(rows) => rows.bytes(),
            Self::Hybrid(hybrid) => hybrid.bytes(),
        }
    }

    /// The bytes that sweeps before the correction, from zero, the residual and sweeps
    /// after the correction move.
    pub(crate) fn cycle_bytes(&self, before: usize, after: usize) -> [usize; 3] {
        match self {
            Self::Rows(rows) => [
                rows.sweeps_bytes(before, true),
                rows.residual_bytes(),
                rows.sweeps_bytes(after, false),
            ],
            Self::Hybrid(hybrid) => [hybrid.before_bytes(before), 0, hybrid.after_bytes(after)],
        }
    }
}
