//! The coarse operator of a prolongation with at most two entries a row, such as
//! linear interpolation on refined edges.
//!
//! Two coarse rows are coupled if a fine row has both as parents: that is the whole
//! pattern wherever fine rows couple only inside coarse elements. So it is known
//! before the sums, which then go straight to their places, without a branch.

use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::pattern::Pattern;
use crate::sparse::real::Real;
use crate::sparse::symmetric::{UpperRows, from_upper};
use octruss_base::chunks::{map_chunks, map_heavy_ranges};
use octruss_base::large_array::zeroed;
use std::sync::Arc;

/// The coarse columns of a fine row and their weights. A column that is missing is
/// the number of columns, with weight 0.
#[derive(Clone, Copy, Default)]
struct Parents<W> {
    columns: [u32; 2],
    weights: [W; 2],
}

/// Where sums for columns outside the pattern go.
const OUTSIDE: u32 = 0;
/// Where the sums of missing parents go.
const MISSING: u32 = 1;
/// Where the sum of the row's first column goes, the others behind it.
const FIRST: u32 = 2;

/// Pᵀ A P for a symmetric A, given P and its transpose, or `None` if a row of P has
/// more than two entries or the pattern is not the one of pairs of parents. The
/// pattern of the result may be known from another A; whether it is the one of pairs
/// is found out again, so that every A of one pattern goes the same way.
pub(crate) fn two_parent_galerkin<E: Entry<Real = f64>, W: Real>(
    a: &Csr<E>,
    (p, p_transposed): (&Csr<W>, &Csr<W>),
    known: Option<&Arc<Pattern>>,
) -> Option<Csr<E>> {
    let parents = parents(p)?;
    let n = p.columns();
    let workspace = || {
        let mut slots = zeroed(n + 1);
        slots[n] = MISSING;
        (slots, Vec::new(), Vec::new())
    };
    let chunks = map_heavy_ranges(n, workspace, |(slots, columns, sums), rows| {
        let mut upper = UpperRows::default();
        let mut is_complete = true;
        for i in rows {
            let fine_rows = p_transposed.row(i).0;
            neighbours(&parents, fine_rows, [i, n].map(|j| j as u32), columns);
            for (slot, &j) in (FIRST..).zip(&*columns) {
                slots[j as usize] = slot;
            }
            sums.clear();
            sums.resize(columns.len() + FIRST as usize, E::default());
            let mut has_outside = false;
            let (fine_rows, weights) = p_transposed.row(i);
            for (&k, weight) in fine_rows.iter().zip(weights) {
                let weight = weight.to_f64();
                let (fine_columns, values) = a.row(k as usize);
                for (&fine_column, &value) in fine_columns.iter().zip(values) {
                    let parents = &parents[fine_column as usize];
                    for (column, share) in parents.columns.into_iter().zip(parents.weights) {
                        let slot = slots[column as usize];
                        has_outside |= slot == OUTSIDE;
                        let sum = &mut sums[slot as usize];
                        *sum = sum.add_scaled(weight * share.to_f64(), value);
                    }
                }
            }
            is_complete &= !has_outside;
            // Sums left of the diagonal were made only because leaving them out
            // takes longer.
            let entries = columns.iter().copied().zip(sums[FIRST as usize..].iter().copied());
            upper.push(entries.skip_while(|(j, _)| (*j as usize) < i));
            columns.iter().for_each(|&j| slots[j as usize] = OUTSIDE);
        }
        is_complete.then_some(upper)
    });
    let chunks: Option<Vec<UpperRows<E>>> = chunks.into_iter().collect();
    Some(from_upper(n, &chunks?, known))
}

fn parents<W: Real>(p: &Csr<W>) -> Option<Vec<Parents<W>>> {
    let (none, zero) = (p.columns() as u32, W::default());
    let mut all = zeroed(p.rows());
    let chunks = map_chunks(&mut all, |first, chunk| {
        let rows = p.rows_in(first..first + chunk.len());
        chunk.iter_mut().zip(rows).all(|(parents, row)| {
            *parents = match row {
                ([], _) => Parents { columns: [none; 2], weights: [zero; 2] },
                (&[j], &[w]) => Parents { columns: [j, none], weights: [w, zero] },
                (&[j, k], &[v, w]) => Parents { columns: [j, k], weights: [v, w] },
                _ => return false,
            };
            true
        })
    });
    chunks.into_iter().all(|is_right| is_right).then_some(all)
}

/// The columns of row `i`, ascending: all parents of the fine rows that it is a
/// parent of.
fn neighbours<W: Real>(
    parents: &[Parents<W>],
    fine_rows: &[u32],
    [i, none]: [u32; 2],
    columns: &mut Vec<u32>,
) {
    columns.clear();
    // One of the two is the row itself, the last, or only one, is often missing.
    let other = |k: &u32| {
        let [first, last] = parents[*k as usize].columns;
        if last == i { first } else { last }
    };
    columns.extend(fine_rows.iter().map(other).filter(|j| *j != none));
    if !fine_rows.is_empty() {
        columns.push(i);
    }
    // With rows in the order of edges this is so already, but for the row itself.
    columns.sort_unstable();
    columns.dedup();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::multiply::multiply;
    use crate::sparse::transpose::transpose;
    use crate::toy::{interpolation, second_difference, tridiagonal};

    #[test]
    fn linear_interpolation_makes_half_the_second_difference() {
        for n in [1, 2, 7, 2000] {
            let p = interpolation(n);
            let a = second_difference(2 * n + 1);
            let coarse = two_parent_galerkin(&a, (&p, &transpose(&p)), None);
            assert_eq!(coarse, Some(tridiagonal(n, -0.5, 1.0)));
        }
    }

    #[test]
    fn other_patterns_are_left_to_the_general_product() {
        // The square of the second difference couples coarse points two apart.
        let (p, a) = (interpolation(5), second_difference(11));
        let wide = multiply(&a, &a);
        assert_eq!(two_parent_galerkin(&wide, (&p, &transpose(&p)), None), None);
        let three = Csr::new(3, vec![0, 3], vec![0, 1, 2], vec![1.0; 3]).unwrap();
        let one = Csr::new(1, vec![0, 1], vec![0], vec![1.0]).unwrap();
        assert_eq!(two_parent_galerkin(&one, (&three, &transpose(&three)), None), None);
    }
}
