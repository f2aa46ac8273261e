//! Rows on an unfolded mesh as rows on the mesh itself.

use crate::core::mirrors::Unfolded;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;

/// The matrix with the weights of images given to what they are images of. For functions
/// that are alike on both sides of each mirror plane the two are the same.
pub(crate) fn folded(matrix: SubdivisionMatrix, unfolded: &Unfolded) -> SubdivisionMatrix {
    if !unfolded.has_mirrors() {
        return matrix;
    }
    SubdivisionMatrix::from_rows(matrix.rows(), unfolded.vertices(), |row, entries| {
        let (columns, weights) = matrix.row(row);
        let terms = columns.iter().zip(weights);
        terms.for_each(|(&column, &weight)| entries.add(unfolded.original(column), weight));
    })
}
