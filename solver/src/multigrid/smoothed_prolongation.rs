//! Prolongation smoothed by a step of Jacobi's method, as smoothed aggregation has it
//! (Vaněk, Mandel and Brezina 1996): (I − ω D⁻¹ A) P with ω = 4 / (3 λmax(D⁻¹A)).

use crate::krylov::lanczos::largest_eigenvalue;
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::multiply::multiply_with;
use crate::sparse::transpose::transpose;

/// The smoothed prolongation to the free directions of this level: blocks where the
/// matrix has blocks, since it mixes components.
pub(crate) fn smoothed<E: Entry<Real = f64>>(
    (matrix, diagonal): (&Csr<E>, &Diagonal<E>),
    prolongation: &Csr<f64>,
    fine: &Projectors<E>,
) -> Csr<E> {
    let end = largest_eigenvalue(matrix, &diagonal.entries, &diagonal.inverses);
    let omega = 4.0 / (3.0 * end.estimate);
    // A P holds all columns of P, since A has a diagonal.
    let product = multiply_with(matrix, prolongation, |a: E, p| (p, a));
    let mut values = Vec::with_capacity(product.nonzeros());
    for row in 0..product.rows() {
        let (columns, sums) = product.row(row);
        for (&column, &sum) in columns.iter().zip(sums) {
            let weight = prolongation.get(row, column as usize).unwrap_or(0.0);
            let step = diagonal.inverses[row].times(sum).scaled(-omega);
            let entry = step.add_scaled(weight, E::identity());
            values.push(fine.get(row).map_or(entry, |q| q.times(entry)));
        }
    }
    product.with_values(values)
}

/// C Pᵀ A P C + t (I − C) for a P of entries to free directions and the coarse
/// projectors C, as in `galerkin`; by two sparse products.
pub(crate) fn galerkin_of_entries<E: Entry<Real = f64>>(
    matrix: &Csr<E>,
    prolongation: &Csr<E>,
    coarse: &Projectors<E>,
) -> Csr<E> {
    let times = |a: E, b: E| (1.0, a.times(b));
    let half = multiply_with(matrix, prolongation, times);
    let product = multiply_with(&transpose(prolongation), &half, times);
    if coarse.is_empty() {
        return product;
    }
    let mut values = product.values().to_vec();
    for row in 0..product.rows() {
        let first = product.offset(row);
        for (k, &column) in product.row(row).0.iter().enumerate() {
            let value = &mut values[first + k];
            *value = coarse.between((row, column as usize), *value);
        }
    }
    product.with_values(values)
}
