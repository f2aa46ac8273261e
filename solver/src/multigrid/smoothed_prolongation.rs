//! Prolongation smoothed by a step of Jacobi's method, as smoothed aggregation has it
//! (Vaněk, Mandel and Brezina 1996): (I − ω D⁻¹ A) P with ω = 4 / (3 λmax(D⁻¹A)).

use crate::krylov::lanczos::largest_eigenvalue;
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::sparse::accumulator::Accumulator;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::multiply::multiply_with;
use crate::sparse::rows::for_rows;
use crate::sparse::symmetric::{UpperRows, from_upper};
use crate::sparse::transpose::transpose;
use octruss_base::chunks::map_heavy_ranges;
use octruss_base::large_array::zeroed;

/// The smoothed prolongation to the free directions of this level: entries as the matrix
/// has them, since it mixes components. `as_entry` makes one of a weight of P.
pub(crate) fn smoothed<E: Entry<Real = f64>, W: Copy + Sync>(
    (matrix, diagonal): (&Csr<E>, &Diagonal<E>),
    prolongation: &Csr<W>,
    fine: &Projectors<E>,
    as_entry: impl Fn(W) -> E + Sync,
) -> Csr<E> {
    let end = largest_eigenvalue(matrix, &diagonal.entries, &diagonal.inverses);
    let omega = 4.0 / (3.0 * end.estimate);
    // A P holds all columns of P, since A has a diagonal.
    let product = multiply_with(matrix, prolongation, |a: E, p| (1.0, a.times(as_entry(p))));
    let mut values: Vec<E> = zeroed(product.nonzeros());
    for_rows(
        product.rows(),
        |row| product.offset(row),
        &mut values[..],
        |row, values: &mut [E]| {
            let (columns, sums) = product.row(row);
            for ((&column, &sum), value) in columns.iter().zip(sums).zip(values) {
                let step = diagonal.inverses[row].times(sum).scaled(-omega);
                let kept = prolongation.get(row, column as usize).map(&as_entry);
                let entry = kept.map_or(step, |weight| step.add_scaled(1.0, weight));
                *value = fine.get(row).map_or(entry, |q| q.times(entry));
            }
        },
    );
    product.with_values(values)
}

/// C Pᵀ A P C + t (I − C) for a P of entries to free directions and the coarse
/// projectors C, as in `galerkin`; by the product A P, and the upper triangle of Pᵀ times
/// that.
pub(crate) fn galerkin_of_entries<E: Entry<Real = f64>>(
    matrix: &Csr<E>,
    prolongation: &Csr<E>,
    coarse: &Projectors<E>,
) -> Csr<E> {
    let half = multiply_with(matrix, prolongation, |a: E, p: E| (1.0, a.times(p)));
    let restriction = transpose(prolongation);
    let n = prolongation.columns();
    let chunks = map_heavy_ranges(
        n,
        || Accumulator::<E>::new(n),
        |row, rows| {
            let mut upper = UpperRows::default();
            for i in rows {
                row.clear();
                let (fine_rows, weights) = restriction.row(i);
                for (&k, &weight) in fine_rows.iter().zip(weights) {
                    let (columns, values) = half.row(k as usize);
                    let from = columns.partition_point(|j| (*j as usize) < i);
                    let terms = columns[from..].iter().zip(&values[from..]);
                    row.add(terms.map(|(&j, &value)| (j, 1.0, weight.times(value))));
                }
                row.sort();
                upper.push(row.drain().map(|(j, sum)| (j, coarse.between((i, j as usize), sum))));
            }
            upper
        },
    );
    drop((half, restriction));
    from_upper(n, &chunks, None)
}
