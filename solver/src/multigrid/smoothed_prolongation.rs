//! Prolongation smoothed by a step of Jacobi's method, as smoothed aggregation has it
//! (Vaněk, Mandel and Brezina 1996): (I − ω D⁻¹ A) P with ω = 4 / (3 λmax(D⁻¹A)).

use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::multiply::multiply_with;

/// The smoothed prolongation to the free directions of this level: entries as the matrix
/// has them, since it mixes components. `as_entry` makes one of a weight of P.
pub(crate) fn smoothed<E: Entry<Real = f64>, W: Copy + Sync>(
    (matrix, diagonal): (&Csr<E>, &mut Diagonal<E>),
    prolongation: &Csr<W>,
    fine: &Projectors<E>,
    as_entry: impl Fn(W) -> E + Sync,
) -> Csr<E> {
    let omega = 4.0 / (3.0 * diagonal.find_upper_end(matrix).estimate);
    // A P holds all columns of P, since A has a diagonal.
    let finished = |row: usize, column: u32, sum: E| {
        let step = diagonal.inverses[row].times(sum).scaled(-omega);
        let kept = prolongation.get(row, column as usize).map(&as_entry);
        let entry = kept.map_or(step, |weight| step.add_scaled(1.0, weight));
        fine.get(row).map_or(entry, |q| q.times(entry))
    };
    multiply_with(matrix, prolongation, |a: E, p| (1.0, a.times(as_entry(p))), finished)
}
