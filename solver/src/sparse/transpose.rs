//! The transpose of a sparse matrix.

use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::rows::build_rows;
use octruss_base::groups::Groups;

/// Aᵀ by grouping entries by columns; blocks are transposed too. Entries of a column
/// come in the order of their rows, so the columns of the result ascend by
/// themselves.
pub fn transpose<E: Entry>(matrix: &Csr<E>) -> Csr<E> {
    let columns = Groups::new(matrix.columns(), matrix.rows(), |i| {
        let (columns, values) = matrix.row(i);
        columns.iter().zip(values).map(move |(&j, &value)| (j, (i as u32, value)))
    });
    build_rows(
        (matrix.columns(), matrix.rows()),
        |j| columns.of(j).len(),
        |j, indices, values| {
            let places = indices.iter_mut().zip(values);
            for (&(row, entry), (index, value)) in columns.of(j).iter().zip(places) {
                (*index, *value) = (row, entry.transposed());
            }
        },
    )
}
