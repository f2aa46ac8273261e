//! Sparse products, and the coarse operator Pᵀ A P made of two of them.
//!
//! Row-wise after Gustavson (1978): row i of A B is the sum of the rows of B
//! that row i of A names, gathered in a dense accumulator. One pass: each chunk
//! of rows has an accumulator of its own and writes its entries behind each
//! other; the chunks are joined in order. Least traffic: every entry of A once,
//! a row of B for each entry of A, the result once (12 bytes an entry).

use crate::chunks::map_ranges;
use crate::csr::Csr;
use crate::entry::Entry;

/// A B, with every entry that the patterns can produce, zeros included.
///
/// # Panics
/// If the inner dimensions differ.
pub fn multiply(a: &Csr<f64>, b: &Csr<f64>) -> Csr<f64> {
    multiply_by(a, b, |a, b, sum| sum + a * b)
}

/// Pᵀ A P for a symmetric A, a number of P times an entry of A. The lower triangle
/// is a copy of the upper one, so that the result is symmetric to the last bit.
pub fn galerkin<E: Entry<Real = f64>>(a: &Csr<E>, p: &Csr<f64>, p_transposed: &Csr<f64>) -> Csr<E> {
    let a_p = multiply_by(a, p, |a, p, sum: E| sum.add_scaled(p, a));
    mirror_upper(&multiply_by(p_transposed, &a_p, |p, a, sum: E| sum.add_scaled(p, a)))
}

/// A B where `add(a, b, sum)` is sum + a b.
fn multiply_by<A: Copy + Sync, B: Copy + Sync, C: Entry>(
    a: &Csr<A>,
    b: &Csr<B>,
    add: impl Fn(A, B, C) -> C + Sync,
) -> Csr<C> {
    assert_eq!(a.columns(), b.rows(), "columns of the left, rows of the right factor");
    let chunks = map_ranges(a.rows(), |rows| {
        let mut gathered = Gathered::new(b.columns());
        let mut ends = Vec::with_capacity(rows.len());
        for i in rows {
            let (indices, values) = a.row(i);
            for (&k, &weight) in indices.iter().zip(values) {
                let (columns, row) = b.row(k as usize);
                for (&j, &v) in columns.iter().zip(row) {
                    let sum = gathered.at(j);
                    *sum = add(weight, v, *sum);
                }
            }
            gathered.end_row();
            ends.push(gathered.indices.len());
        }
        (ends, gathered.indices, gathered.values)
    });
    join(b.columns(), a.rows(), &chunks)
}

/// One row at a time as a dense accumulator, finished rows behind each other.
struct Gathered<E> {
    sums: Vec<E>,
    /// For each column the number of the last row that touched it.
    touched_by: Vec<u32>,
    row: u32,
    row_start: usize,
    indices: Vec<u32>,
    values: Vec<E>,
}

impl<E: Entry> Gathered<E> {
    fn new(columns: usize) -> Self {
        Self {
            sums: vec![E::default(); columns],
            touched_by: vec![u32::MAX; columns],
            row: 0,
            row_start: 0,
            indices: Vec::new(),
            values: Vec::new(),
        }
    }

    #[inline]
    fn at(&mut self, column: u32) -> &mut E {
        let j = column as usize;
        if self.touched_by[j] != self.row {
            self.touched_by[j] = self.row;
            self.sums[j] = E::default();
            self.indices.push(column);
        }
        &mut self.sums[j]
    }

    fn end_row(&mut self) {
        let row = &mut self.indices[self.row_start..];
        row.sort_unstable();
        self.values.extend(row.iter().map(|&j| self.sums[j as usize]));
        self.row_start = self.indices.len();
        self.row += 1;
    }
}

type Chunk<E> = (Vec<usize>, Vec<u32>, Vec<E>);

fn join<E: Entry>(columns: usize, rows: usize, chunks: &[Chunk<E>]) -> Csr<E> {
    let mut offsets = Vec::with_capacity(rows + 1);
    offsets.push(0);
    for (ends, ..) in chunks {
        let base = offsets[offsets.len() - 1];
        offsets.extend(ends.iter().map(|end| base + end));
    }
    let indices: Vec<&[u32]> = chunks.iter().map(|(_, indices, _)| &**indices).collect();
    let values: Vec<&[E]> = chunks.iter().map(|(.., values)| &**values).collect();
    Csr::trusted(columns, offsets, indices.concat(), values.concat())
}

/// The matrix with entry (i, j) replaced by the transpose of entry (j, i) wherever j < i; the
/// pattern must be symmetric.
fn mirror_upper<E: Entry>(matrix: &Csr<E>) -> Csr<E> {
    let chunks = map_ranges(matrix.rows(), |rows| {
        let entries = matrix.offset(rows.start)..matrix.offset(rows.end);
        let mut values = Vec::with_capacity(entries.len());
        for i in rows {
            let (indices, row) = matrix.row(i);
            for (&j, &v) in indices.iter().zip(row) {
                let j = j as usize;
                values.push(if j < i { matrix.get(j, i).map_or(v, E::transposed) } else { v });
            }
        }
        values
    });
    matrix.with_values(chunks.concat())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toy::{interpolation, second_difference, tridiagonal};
    use crate::transpose::transpose;

    #[test]
    fn linear_interpolation_makes_half_the_second_difference() {
        // One half row, two fine points apart: (−1, 2, −1) / 2, exact in binary.
        for n in [1, 2, 7, 2000] {
            let p = interpolation(n);
            let coarse = galerkin(&second_difference(2 * n + 1), &p, &transpose(&p));
            assert_eq!(coarse, tridiagonal(n, -0.5, 1.0));
        }
    }

    #[test]
    fn the_product_keeps_zeros_that_the_patterns_produce() {
        let row = Csr::new(2, vec![0, 2], vec![0, 1], vec![1.0, -1.0]).unwrap();
        let column = Csr::new(1, vec![0, 1, 2], vec![0, 0], vec![3.0, 3.0]).unwrap();
        let product = multiply(&row, &column);
        assert_eq!((product.nonzeros(), product.get(0, 0)), (1, Some(0.0)));
    }
}
