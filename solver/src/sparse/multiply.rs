//! Sparse products, row-wise after Gustavson (1978): row i of A B is the sum of the
//! rows of B that row i of A names.

use crate::sparse::accumulator::Accumulator;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use octruss_base::chunks::map_heavy_ranges;

/// A B, with every entry that the patterns can produce, zeros included.
///
/// # Panics
/// If the inner dimensions differ.
pub fn multiply(a: &Csr<f64>, b: &Csr<f64>) -> Csr<f64> {
    multiply_with(a, b, |a, b| (a, b), |_, _, sum| sum)
}

/// A B where the product of entries a and b is factor · value for (factor, value) of
/// `term(a, b)`, and each sum, in a row and a column, becomes what `finished` makes of it.
pub(crate) fn multiply_with<A: Copy + Sync, B: Copy + Sync, E: Entry>(
    a: &Csr<A>,
    b: &Csr<B>,
    term: impl Fn(A, B) -> (E::Real, E) + Sync,
    finished: impl Fn(usize, u32, E) -> E + Sync,
) -> Csr<E> {
    assert_eq!(a.columns(), b.rows(), "columns of the left, rows of the right factor");
    let workspace = || Accumulator::<E>::new(b.columns());
    let chunks = map_heavy_ranges(a.rows(), workspace, |row, rows| {
        let (mut lengths, mut indices, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for i in rows {
            row.clear();
            let (a_indices, a_values) = a.row(i);
            for (&k, &weight) in a_indices.iter().zip(a_values) {
                let (columns, b_values) = b.row(k as usize);
                row.add(columns.iter().zip(b_values).map(|(&j, &v)| {
                    let (factor, value) = term(weight, v);
                    (j, factor, value)
                }));
            }
            row.sort();
            lengths.push(row.count());
            for (j, sum) in row.drain() {
                indices.push(j);
                values.push(finished(i, j, sum));
            }
        }
        // Vectors that grew have room for up to twice as much.
        indices.shrink_to_fit();
        values.shrink_to_fit();
        (lengths, indices, values)
    });
    let mut offsets = Vec::with_capacity(a.rows() + 1);
    offsets.push(0);
    let mut end = 0;
    for length in chunks.iter().flat_map(|(lengths, ..)| lengths) {
        end += length;
        offsets.push(end);
    }
    let (mut indices, mut values) = (Vec::with_capacity(end), Vec::with_capacity(end));
    // A chunk is freed as soon as it is copied: else the product would be there twice.
    for (_, chunk_indices, chunk_values) in chunks {
        indices.extend(chunk_indices);
        values.extend(chunk_values);
    }
    Csr::trusted(b.columns(), offsets, indices, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_product_keeps_zeros_that_the_patterns_produce() {
        let row = Csr::new(2, vec![0, 2], vec![0, 1], vec![1.0, -1.0]).unwrap();
        let column = Csr::new(1, vec![0, 1, 2], vec![0, 0], vec![3.0, 3.0]).unwrap();
        let product = multiply(&row, &column);
        assert_eq!((product.nonzeros(), product.get(0, 0)), (1, Some(0.0)));
    }
}
