//! The coarse operator of a prolongation with at most two entries a row, such as
//! linear interpolation on refined edges.
//!
//! Two coarse rows are coupled if a fine row has both as parents: that is the whole
//! pattern wherever fine rows couple only inside coarse elements. So it is known
//! before the sums, which then go straight to their places, without a branch.

use crate::chunks::{map_heavy_ranges, map_ranges};
use crate::csr::Csr;
use crate::entry::Entry;
use crate::symmetric::{UpperRows, from_upper};

/// The coarse columns of a fine row and their weights. A column that is missing is
/// the number of columns, with weight 0.
#[derive(Clone, Copy)]
struct Parents {
    columns: [u32; 2],
    weights: [f64; 2],
}

/// Where sums for columns outside the pattern go.
const OUTSIDE: u32 = 0;
/// Where the sums of missing parents go.
const MISSING: u32 = 1;
/// Where the sum of the row's first column goes, the others behind it.
const FIRST: u32 = 2;

/// Pᵀ A P for a symmetric A, or `None` if a row of P has more than two entries or
/// the pattern is not the one of pairs of parents.
pub(crate) fn two_parent_galerkin<E: Entry<Real = f64>>(
    a: &Csr<E>,
    p: &Csr<f64>,
    p_transposed: &Csr<f64>,
) -> Option<Csr<E>> {
    let parents = parents(p)?;
    let n = p.columns();
    let workspace = || {
        let mut slots = vec![OUTSIDE; n + 1];
        slots[n] = MISSING;
        (slots, Vec::new(), Vec::new())
    };
    let chunks = map_heavy_ranges(n, workspace, |(slots, columns, sums), rows| {
        let mut upper = UpperRows::default();
        let mut is_complete = true;
        for i in rows {
            neighbours(&parents, p_transposed.row(i).0, n, columns);
            for (slot, &j) in (FIRST..).zip(&*columns) {
                slots[j as usize] = slot;
            }
            sums.clear();
            sums.resize(columns.len() + FIRST as usize, E::default());
            let mut has_outside = false;
            let (fine_rows, weights) = p_transposed.row(i);
            for (&k, &weight) in fine_rows.iter().zip(weights) {
                let (fine_columns, values) = a.row(k as usize);
                for (&fine_column, &value) in fine_columns.iter().zip(values) {
                    let parents = &parents[fine_column as usize];
                    for (column, share) in parents.columns.into_iter().zip(parents.weights) {
                        let slot = slots[column as usize];
                        has_outside |= slot == OUTSIDE;
                        let sum = &mut sums[slot as usize];
                        *sum = sum.add_scaled(weight * share, value);
                    }
                }
            }
            is_complete &= !has_outside;
            // Sums left of the diagonal were made only because leaving them out
            // takes longer.
            let diagonal = columns.partition_point(|&j| (j as usize) < i);
            let sums = sums[FIRST as usize..][diagonal..].iter().copied();
            upper.push(&columns[diagonal..], sums);
            columns.iter().for_each(|&j| slots[j as usize] = OUTSIDE);
        }
        is_complete.then_some(upper)
    });
    let chunks: Option<Vec<UpperRows<E>>> = chunks.into_iter().collect();
    Some(from_upper(n, &chunks?))
}

fn parents(p: &Csr<f64>) -> Option<Vec<Parents>> {
    let none = p.columns() as u32;
    let of = |row: usize| match p.row(row) {
        ([], _) => Some(Parents { columns: [none; 2], weights: [0.0; 2] }),
        (&[j], &[w]) => Some(Parents { columns: [j, none], weights: [w, 0.0] }),
        (&[j, k], &[v, w]) => Some(Parents { columns: [j, k], weights: [v, w] }),
        _ => None,
    };
    let chunks = map_ranges(p.rows(), |rows| rows.map(of).collect::<Option<Vec<_>>>());
    Some(chunks.into_iter().collect::<Option<Vec<_>>>()?.concat())
}

/// The columns of a row, ascending: all parents of the fine rows that it is a parent
/// of.
fn neighbours(parents: &[Parents], fine_rows: &[u32], n: usize, columns: &mut Vec<u32>) {
    columns.clear();
    let all = fine_rows.iter().flat_map(|&k| parents[k as usize].columns);
    columns.extend(all.filter(|&j| (j as usize) < n));
    columns.sort_unstable();
    columns.dedup();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::multiply::multiply;
    use crate::toy::{interpolation, second_difference, tridiagonal};
    use crate::transpose::transpose;

    #[test]
    fn linear_interpolation_makes_half_the_second_difference() {
        for n in [1, 2, 7, 2000] {
            let p = interpolation(n);
            let a = second_difference(2 * n + 1);
            let coarse = two_parent_galerkin(&a, &p, &transpose(&p));
            assert_eq!(coarse, Some(tridiagonal(n, -0.5, 1.0)));
        }
    }

    #[test]
    fn other_patterns_are_left_to_the_general_product() {
        // The square of the second difference couples coarse points two apart.
        let (p, a) = (interpolation(5), second_difference(11));
        let wide = multiply(&a, &a);
        assert_eq!(two_parent_galerkin(&wide, &p, &transpose(&p)), None);
        let three = Csr::new(3, vec![0, 3], vec![0, 1, 2], vec![1.0; 3]).unwrap();
        let one = Csr::new(1, vec![0, 1], vec![0], vec![1.0]).unwrap();
        assert_eq!(two_parent_galerkin(&one, &three, &transpose(&three)), None);
    }
}
