//! The smoother of one level, whichever it is, with the matrix in the form it needs.

use crate::colouring::Colouring;
use crate::csr::Csr;
use crate::diagonal::Diagonal;
use crate::domains::Domains;
use crate::entry::Entry;
use crate::gauss_seidel::Order;
use crate::hybrid_gauss_seidel::HybridGaussSeidel;
use crate::options::MultigridOptions;
use crate::projectors::Projectors;
use crate::row_smoothing::RowSmoothing;

/// A level's matrix and its smoother, with its data and work vectors.
pub(crate) enum Smoothing<E: Entry> {
    Rows(RowSmoothing<E>),
    Hybrid(HybridGaussSeidel<E>),
}

/// How the rows of a matrix are grouped, which depends on its pattern alone.
pub(crate) enum Grouping {
    Colours(Colouring),
    Domains(Domains),
}

impl<E: Entry> Smoothing<E> {
    /// The smoother of `scale` times a matrix, in the cycle's precision: by domains where
    /// some are given. Colours of the rows may be known.
    pub(crate) fn new<D: Entry<Real = f64>>(
        (matrix, diagonal, scale): (&Csr<D>, Diagonal<D>, f64),
        projectors: &Projectors<D>,
        options: &MultigridOptions,
        known: Option<Grouping>,
    ) -> Self {
        let colours = match known {
            Some(Grouping::Domains(domains)) => {
                return Self::Hybrid(HybridGaussSeidel::new((matrix, &diagonal, scale), domains));
            }
            Some(Grouping::Colours(colours)) => Some(colours),
            None => None,
        };
        Self::Rows(RowSmoothing::new((matrix, diagonal, scale), projectors, options, colours))
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
