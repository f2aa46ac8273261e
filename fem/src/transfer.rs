//! Prolongations from meshes: subdivision matrices between free unknowns.

use crate::boundary::dofs::Dofs;
use crate::error::Error;
use octruss_mesh::SubdivisionMatrix;
use octruss_solver::{Csr, build_rows, check_size};

/// The rows and columns of a subdivision matrix that belong to free unknowns.
///
/// Constrained rows and columns are dropped, nothing is renormalised: an error
/// that vanishes on a fixed surface continues oddly across it, which is just
/// what missing weights mean. (Renormalised rows halve the convergence rate.)
///
/// # Errors
/// [`octruss_solver::Error::Size`] if the matrix does not lead from the coarse to the fine vertices.
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
