//! How wrong a solution is, judged row by row.

use crate::sparse::csr::Csr;
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::kernels::residual;
use crate::sparse::real::Real;
use octruss_base::chunks::{for_chunks, map_ranges};
use octruss_base::large_array::zeroed;

/// max_i |b − A x|_i / (|A| |x| + |b|)_i over all numbers of all rows: the smallest ε such
/// that x solves a system whose every number differs by a share of at most ε from that of
/// this one (Oettli and Prager 1964; Arioli, Demmel and Duff 1989). Some units of rounding
/// are all that can be asked for, however ill-conditioned the matrix is.
///
/// A row of zeros in which nothing is asked for has none. NaN where x is none.
///
/// # Panics
/// If a vector's length does not fit the matrix.
pub fn backward_error<E: Entry>(matrix: &Csr<E>, x: &[E::Nodal], b: &[E::Nodal]) -> f64 {
    let mut r = vec![E::Nodal::default(); b.len()];
    residual(matrix, x, b, &mut r);
    largest_share(&r, &row_sizes(matrix, x, b))
}

/// (|A| |x| + |b|)_i for each number of each row: what a residual is summed up from.
pub(crate) fn row_sizes<E: Entry>(
    matrix: &Csr<E>,
    x: &[E::Nodal],
    b: &[E::Nodal],
) -> Vec<E::Nodal> {
    assert!(x.len() == matrix.columns() && b.len() == matrix.rows());
    let mut sizes: Vec<E::Nodal> = zeroed(matrix.rows());
    for_chunks(&mut sizes, |first, chunk| {
        for (row, size) in (first..).zip(chunk) {
            let (columns, values) = matrix.row(row);
            *size = E::Nodal::from_fn(|i| {
                let product = |(&column, value): (&u32, &E)| {
                    let x = &x[column as usize];
                    (0..E::SIZE).map(|j| (value.at(i, j) * x.at(j)).to_f64().abs()).sum::<f64>()
                };
                let products: f64 = columns.iter().zip(values).map(product).sum();
                products + b[row].at(i).to_f64().abs()
            });
        }
    });
    sizes
}

/// max_i |r_i| / size_i; 0 / 0 counts as 0.
pub(crate) fn largest_share<V: Nodal>(r: &[V], sizes: &[V]) -> f64 {
    let share = |(r, size): (&V::Real, &V::Real)| {
        let r = r.to_f64().abs();
        if r == 0.0 { 0.0 } else { r / size.to_f64() }
    };
    let (r, sizes) = (V::flat(r), V::flat(sizes));
    let chunks = map_ranges(r.len(), |range| {
        r[range.clone()].iter().zip(&sizes[range]).map(share).fold(0.0, worse)
    });
    chunks.into_iter().fold(0.0, worse)
}

/// The larger; NaN if one is.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toy::second_difference;

    #[test]
    fn a_change_of_one_entry_is_told_by_its_share() {
        // (−1, 2, −1) x = 1 on three points: x = (3, 4, 3) / 2.
        let (matrix, b) = (second_difference(3), [1.0; 3]);
        assert_eq!(backward_error(&matrix, &[1.5, 2.0, 1.5], &b), 0.0);
        // With 2.1 in the middle the first row has 1 − (3 − 2.1) = 0.1 of 3 + 2.1 + 1, the
        // middle one 1 − (4.2 − 3) = −0.2 of 4.2 + 3 + 1.
        let error = backward_error(&matrix, &[1.5, 2.1, 1.5], &b);
        assert!((error - 0.2 / 8.2).abs() < 1e-14);
        assert!(backward_error(&matrix, &[f64::NAN, 0.0, 0.0], &b).is_nan());
    }

    #[test]
    fn blocks_are_judged_number_by_number() {
        let block = [[2.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 1e-9]];
        let matrix = Csr::new(1, vec![0, 1], vec![0], vec![block]).unwrap();
        let error = backward_error(&matrix, &[[1.0, 1.0, 2.0]], &[[2.0, 4.0, 1e-9]]);
        assert!((error - 1.0 / 3.0).abs() < 1e-14);
    }
}
