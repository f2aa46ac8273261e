//! How a level hangs on the next coarser one, and prolongations from meshes:
//! subdivision matrices between free unknowns.

use crate::csr::Csr;
use crate::diagonal::Diagonal;
use crate::dofs::Dofs;
use crate::entry::Entry;
use crate::error::{Error, check_finite, check_size};
use crate::level::Kept;
use crate::projectors::Projectors;
use crate::rows::build_rows;
use crate::smoothed::{galerkin_of_entries, smoothed};
use crate::weights::Weights;
use octruss_mesh::SubdivisionMatrix;

/// How a level hangs on the next coarser one.
#[derive(Debug, Clone, PartialEq)]
pub struct Transfer<E> {
    /// From the coarse unknowns to those of this level, a number an entry, which acts
    /// on all components of a block alike.
    pub prolongation: Csr<f64>,
    /// Whether it is smoothed first by a step of Jacobi's method:
    /// (I − ω D⁻¹ A) P with ω = 4 / (3 λmax) and the matrix of this level.
    pub smooth: bool,
    /// The coarse matrix, assembled on the coarse mesh; the Galerkin product Pᵀ A P
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
        (matrix, diagonal): (&Csr<E>, &Diagonal<E>),
        [fine, coarse]: [&Projectors<E>; 2],
    ) -> (Kept<F>, Csr<E>) {
        let Self { prolongation: p, smooth, coarse_matrix } = self;
        if smooth {
            let smoothed = smoothed((matrix, diagonal), &p, fine);
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

/// The rows and columns of a subdivision matrix that belong to free unknowns.
///
/// Constrained rows and columns are dropped, nothing is renormalised: an error
/// that vanishes on a fixed surface continues oddly across it, which is just
/// what missing weights mean. (Renormalised rows halve the convergence rate.)
///
/// # Errors
/// [`Error::Size`] if the matrix does not lead from the coarse to the fine vertices.
pub fn restrict_to_free(
    matrix: &SubdivisionMatrix,
    fine: &Dofs,
    coarse: &Dofs,
) -> Result<Csr<f64>, Error> {
    check_size("rows of a subdivision matrix", matrix.rows(), fine.vertices())?;
    check_size("columns of a subdivision matrix", matrix.columns(), coarse.vertices())?;
    let entries = |row: usize| {
        let (columns, weights) = matrix.row(fine.free()[row] as usize);
        let free = |(&column, &weight)| coarse.unknown(column).map(|unknown| (unknown, weight));
        columns.iter().zip(weights).filter_map(free)
    };
    Ok(build_rows(
        (fine.unknowns(), coarse.unknowns()),
        |row| entries(row).count(),
        |row, indices, values| {
            for ((unknown, weight), (index, value)) in
                entries(row).zip(indices.iter_mut().zip(values))
            {
                (*index, *value) = (unknown, weight);
            }
        },
    ))
}
