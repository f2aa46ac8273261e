//! The transpose of a sparse matrix.

use crate::csr::Csr;
use crate::entry::Entry;

/// Aᵀ by a counting sort on columns; blocks are transposed too. Rows are visited
/// in order, so the columns of the result ascend by themselves.
pub fn transpose<E: Entry>(matrix: &Csr<E>) -> Csr<E> {
    let mut offsets = vec![0usize; matrix.columns() + 1];
    for &j in matrix.indices() {
        offsets[j as usize + 1] += 1;
    }
    for j in 0..matrix.columns() {
        offsets[j + 1] += offsets[j];
    }
    let mut next = offsets.clone();
    let mut indices = vec![0u32; matrix.nonzeros()];
    let mut values = vec![E::default(); matrix.nonzeros()];
    for i in 0..matrix.rows() {
        let (row_indices, row_values) = matrix.row(i);
        for (&j, &v) in row_indices.iter().zip(row_values) {
            let at = next[j as usize];
            next[j as usize] += 1;
            indices[at] = i as u32;
            values[at] = v.transposed();
        }
    }
    Csr::trusted(matrix.rows(), offsets, indices, values)
}
