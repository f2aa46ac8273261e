//! How a level hangs on the next coarser one.

use crate::error::{Error, check_finite, check_size};
use crate::multigrid::galerkin::galerkin_of_entries;
use crate::multigrid::level::Kept;
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoothed_prolongation::smoothed;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::multigrid::weights::Weights;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;

/// How a level hangs on the next coarser one.
#[derive(Debug, Clone, PartialEq)]
pub struct Transfer<E> {
    /// From the coarse unknowns to those of this level, a number an entry, which acts
    /// on all components of a block alike.
    pub prolongation: Csr<f64>,
    /// Whether it is smoothed first by a step of Jacobi's method:
    /// (I − ω D⁻¹ A) P with ω = 4 / (3 λmax) and the matrix of this level.
    pub smooth: bool,
    /// The coarse matrix, however it was made; the Galerkin product Pᵀ A P
    /// if there is none. It must be constrained as the coarse level is.
    pub coarse_matrix: Option<Csr<E>>,
}

impl<E> From<Csr<f64>> for Transfer<E> {
    /// With the Galerkin product, not smoothed.
    fn from(prolongation: Csr<f64>) -> Self {
        Self { prolongation, smooth: false, coarse_matrix: None }
    }
}

impl<E: Entry<Real = f64>> Transfer<E> {
    /// # Errors
    /// [`Error::Size`] unless it leads to so many rows, [`Error::NotFinite`].
    pub(crate) fn check(&self, rows: usize) -> Result<(), Error> {
        check_size("rows of a prolongation", self.prolongation.rows(), rows)?;
        check_finite("prolongation", self.prolongation.values())?;
        let Some(coarse) = &self.coarse_matrix else { return Ok(()) };
        check_size("rows of a coarse matrix", coarse.rows(), self.prolongation.columns())?;
        check_size("columns of a coarse matrix", coarse.columns(), coarse.rows())?;
        check_finite("coarse matrix", E::flat(coarse.values()))
    }

    /// What the cycle keeps of it and the coarse matrix, given the matrix of this level,
    /// and the constrained rows of this and the coarse level.
    pub(crate) fn apply<F: Entry>(
        self,
        (matrix, diagonal): (&Csr<E>, &mut Diagonal<E>),
        [fine, coarse]: [&Projectors<E>; 2],
    ) -> (Kept<F>, Csr<E>) {
        let Self { prolongation: p, smooth, coarse_matrix } = self;
        if smooth {
            let smoothed =
                smoothed((matrix, diagonal), &p, fine, |weight| E::identity().scaled(weight));
            drop(p);
            // A baseline: its product is that of weights that are not yet rounded.
            let product = || galerkin_of_entries(matrix, &smoothed, coarse);
            let given = coarse_matrix.unwrap_or_else(product);
            return (Kept::new(Weights::Entries(smoothed.cast_scaled(1.0))), given);
        }
        // Rounded before any product: coarse matrices belong to the prolongation that
        // the cycle uses.
        let kept = Kept::new(Weights::Numbers(p.cast()));
        drop(p);
        let product = || kept.galerkin((matrix, fine), coarse, None);
        let given = coarse_matrix.or_else(product).expect("the weights are numbers");
        (kept, given)
    }
}
