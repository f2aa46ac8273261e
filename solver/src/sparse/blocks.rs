//! A matrix of blocks as a matrix of numbers.

use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::real::Real;
use crate::sparse::rows::build_rows;

/// `scale` times the matrix, number by number: row k of block row i becomes row
/// SIZE · i + k.
pub(crate) fn expand_blocks<E: Entry>(matrix: &Csr<E>, scale: f64) -> Csr<f64> {
    let n = E::SIZE;
    build_rows(
        (n * matrix.rows(), n * matrix.columns()),
        |row| n * matrix.row(row / n).0.len(),
        |row, indices, values| {
            let (columns, blocks) = matrix.row(row / n);
            let places = indices.chunks_exact_mut(n).zip(values.chunks_exact_mut(n));
            for ((&column, block), (indices, values)) in columns.iter().zip(blocks).zip(places) {
                for k in 0..n {
                    indices[k] = n as u32 * column + k as u32;
                    values[k] = scale * block.at(row % n, k).to_f64();
                }
            }
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_become_their_numbers() {
        let a = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]];
        let blocks = Csr::new(2, vec![0, 0, 1], vec![1], vec![a]).unwrap();
        let expanded = expand_blocks(&blocks, 2.0);
        assert_eq!((expanded.rows(), expanded.columns(), expanded.nonzeros()), (6, 6, 9));
        assert_eq!(expanded.row(4), (&[3, 4, 5][..], &[8.0, 10.0, 12.0][..]));
    }
}
