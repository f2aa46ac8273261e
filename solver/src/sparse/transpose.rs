//! The transpose of a sparse matrix.

use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::rows::build_rows;
use octruss_base::groups::Groups;

/// Aᵀ by grouping entries by columns; blocks are transposed too. Entries of a column
/// come in the order of their rows, so the columns of the result ascend by
/// themselves.
pub fn transpose<E: Entry>(matrix: &Csr<E>) -> Csr<E> {
    let columns = places_by_column(matrix);
    build_rows(
        (matrix.columns(), matrix.rows()),
        |j| columns.of(j).len(),
        |j, indices, values| {
            let places = indices.iter_mut().zip(values);
            for (&(row, place), (index, value)) in columns.of(j).iter().zip(places) {
                (*index, *value) = (row, matrix.values()[place as usize].transposed());
            }
        },
    )
}

/// For each column its (row, place among all values), rows ascending: the transpose of a
/// matrix whose values, which may be large blocks, stay where they are.
///
/// # Panics
/// If there are 2³² entries or more.
pub(crate) fn places_by_column<E: Copy + Sync>(matrix: &Csr<E>) -> Groups<(u32, u32)> {
    Groups::new(matrix.columns(), matrix.rows(), |i| {
        let places = (matrix.offset(i)..).zip(matrix.row(i).0);
        places.map(move |(place, &j)| (j, (i as u32, place as u32)))
    })
}
