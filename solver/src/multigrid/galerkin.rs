//! The coarse operator Pᵀ A P in one pass over coarse rows, nothing stored between.
//!
//! Coarse row I first sums the rows of A that column I of P names, then sends each
//! of these sums through its row of P. Only the upper triangle is computed; the
//! lower one is its copy, so the result is symmetric to the last bit. Linear
//! prolongation of numbers takes the shorter way of `two_parents`. P is a matrix
//! of numbers whatever A holds. Each row of A is read as often as its row of P has
//! entries, most often from a cache; the result is written twice.

use crate::multigrid::projectors::Projectors;
use crate::multigrid::two_parents::two_parent_galerkin;
use crate::sparse::accumulator::Accumulator;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::pattern::Pattern;
use crate::sparse::real::Real;
use crate::sparse::symmetric::{UpperRows, from_upper};
use crate::sparse::transpose::places_by_column;
use octruss_base::chunks::map_heavy_ranges;
use std::iter::once;
use std::sync::Arc;

/// Pᵀ A P for a symmetric A (of blocks: A with rows and columns, and each block,
/// exchanged is A again), given P and its transpose.
///
/// # Panics
/// If the sizes do not fit.
pub fn galerkin<E: Entry<Real = f64>>(a: &Csr<E>, p: &Csr<f64>, p_transposed: &Csr<f64>) -> Csr<E> {
    let unconstrained = &Projectors::none();
    constrained_galerkin((a, unconstrained), (p, p_transposed), unconstrained, None)
}

/// The coarse operator between the free directions on both levels. With the
/// projectors F of the fine and C of the coarse level, and A = F B F + s (I − F):
/// C Pᵀ F B F P C + t (I − C), where t for each vertex is of the size of its
/// diagonal block.
///
/// The pattern of the result may be known from a product with another A of the same
/// pattern; the values are the same to the last bit.
pub(crate) fn constrained_galerkin<E: Entry<Real = f64>, W: Real>(
    (a, fine): (&Csr<E>, &Projectors<E>),
    (p, p_transposed): (&Csr<W>, &Csr<W>),
    coarse: &Projectors<E>,
    known: Option<&Arc<Pattern>>,
) -> Csr<E> {
    assert_eq!(a.columns(), p.rows(), "rows of the prolongation, columns of the matrix");
    assert_eq!(p_transposed.rows(), p.columns(), "the second is the transpose of the first");
    // With blocks, summing rows of A first spares more than it costs.
    if E::SIZE == 1
        && fine.is_empty()
        && coarse.is_empty()
        && let Some(product) = two_parent_galerkin(a, (p, p_transposed), known)
    {
        return product;
    }
    let rows_of_a = |i, sums: &mut _| add_rows((a, fine), p_transposed.row(i), sums);
    through_prolongation(rows_of_a, (p, |sum, weight: W| (weight.to_f64(), sum)), coarse, known)
}

/// As [`constrained_galerkin`] for a P of entries that leads to free directions.
///
/// # Panics
/// If the sizes do not fit.
pub(crate) fn galerkin_of_entries<E: Entry<Real = f64>>(
    a: &Csr<E>,
    p: &Csr<E>,
    coarse: &Projectors<E>,
) -> Csr<E> {
    assert_eq!(a.columns(), p.rows(), "rows of the prolongation, columns of the matrix");
    let columns = places_by_column(p);
    let rows_of_a = |i, sums: &mut Accumulator<E>| {
        for &(row, place) in columns.of(i) {
            let weight = p.values()[place as usize].transposed();
            let (columns, values) = a.row(row as usize);
            sums.add(columns.iter().zip(values).map(|(&j, &value)| (j, 1.0, weight.times(value))));
        }
    };
    through_prolongation(rows_of_a, (p, |sum: E, weight| (1.0, sum.times(weight))), coarse, None)
}

/// C (Pᵀ A) P C + t (I − C) from a function that adds a row of Pᵀ A to sums. The product
/// of one of these and a weight of P is factor · value for (factor, value) of the
/// function beside P.
fn through_prolongation<E: Entry<Real = f64>, W: Copy + Sync>(
    add_row: impl Fn(usize, &mut Accumulator<E>) + Sync,
    (p, term): (&Csr<W>, impl Fn(E, W) -> (f64, E) + Sync),
    coarse: &Projectors<E>,
    known: Option<&Arc<Pattern>>,
) -> Csr<E> {
    let workspace = || (Accumulator::<E>::new(p.rows()), Accumulator::<E>::new(p.columns()));
    let chunks = map_heavy_ranges(p.columns(), workspace, |(sums, row), rows| {
        let mut upper = UpperRows::default();
        for i in rows {
            sums.clear();
            add_row(i, sums);
            row.clear();
            for (fine_column, sum) in sums.drain() {
                let (columns, weights) = p.row(fine_column as usize);
                // From the end: one comparison that cannot be foreseen, not a search.
                let upper = columns.iter().zip(weights).rev();
                let upper = upper.take_while(|(j, _)| **j as usize >= i);
                row.add(upper.map(|(&j, &weight)| {
                    let (factor, value) = term(sum, weight);
                    (j, factor, value)
                }));
            }
            let projected = |(j, sum)| (j, coarse.between((i, j as usize), sum));
            if let Some(pattern) = known {
                let columns = pattern.upper_row(i).iter();
                upper.push(columns.map(|&j| (j, row.take(j))).map(projected));
            } else {
                row.sort();
                upper.push(row.drain().map(projected));
            }
        }
        upper
    });
    from_upper(p.columns(), &chunks, known)
}

/// sums += Σ w · (row of A), over the rows and weights w given, A without what it
/// holds in constrained directions.
fn add_rows<E: Entry<Real = f64>, W: Real>(
    (a, fine): (&Csr<E>, &Projectors<E>),
    (rows, weights): (&[u32], &[W]),
    sums: &mut Accumulator<E>,
) {
    for (&k, weight) in rows.iter().zip(weights) {
        let weight = weight.to_f64();
        let (columns, values) = a.row(k as usize);
        sums.add(columns.iter().zip(values).map(|(&j, &value)| (j, weight, value)));
        // Off the diagonal a constrained matrix has free directions only.
        if let (Some(q), Some(value)) = (fine.get(k as usize), a.get(k as usize, k as usize)) {
            let without = q.times(value).times(*q).add_scaled(-1.0, value);
            sums.add(once((k, weight, without)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::multiply::multiply;
    use crate::sparse::transpose::transpose;
    use crate::toy::{interpolation, second_difference};

    #[test]
    fn a_wider_pattern_than_that_of_parents_is_summed_all_the_same() {
        // The square of the second difference: halves and integers, exact in binary.
        let (a, p) = (second_difference(4001), interpolation(2000));
        let (wide, p_transposed) = (multiply(&a, &a), transpose(&p));
        let coarse = galerkin(&wide, &p, &p_transposed);
        assert_eq!(coarse, multiply(&p_transposed, &multiply(&wide, &p)));
        // A times column j of P is 1 at fine point c, −½ two points to both sides;
        // so row j is 1 + ¼ + ¼ on the diagonal, −½ − ½ beside it, then ¼.
        assert_eq!(coarse.row(7), (&[5, 6, 7, 8, 9][..], &[0.25, -1.0, 1.5, -1.0, 0.25][..]));
    }

    #[test]
    fn a_known_pattern_changes_no_bit() {
        let (a, p) = (second_difference(4001), interpolation(2000));
        let p_transposed = transpose(&p);
        // The second goes through the general product.
        for a in [a.clone(), multiply(&a, &a)] {
            let numbers = crate::noise(a.nonzeros(), 5);
            let symmetric = |i: usize, j: u32| numbers[i.min(j as usize) + i.abs_diff(j as usize)];
            let values = (0..a.rows()).flat_map(|i| a.row(i).0.iter().map(move |&j| (i, j)));
            let values = values.map(|(i, j)| symmetric(i, j)).collect();
            let (a, free) = (a.with_values(values), &Projectors::none());
            let product = |known: Option<&Arc<Pattern>>| {
                constrained_galerkin((&a, free), (&p, &p_transposed), free, known)
            };
            let new = product(None);
            assert_eq!(product(Some(new.pattern())), new);
        }
    }

    type Block = [[f64; 3]; 3];

    /// A square matrix of numbers, dense.
    fn dense(rows: usize, columns: usize, at: impl Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
        (0..rows).map(|i| (0..columns).map(|j| at(i, j)).collect()).collect()
    }

    fn times(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let sum = |i: usize, j: usize| (0..b.len()).map(|k| a[i][k] * b[k][j]).sum::<f64>();
        dense(a.len(), b[0].len(), sum)
    }

    /// The block-diagonal matrix of projectors.
    fn expanded(n: usize, list: &[(u32, Block)]) -> Vec<Vec<f64>> {
        dense(3 * n, 3 * n, |i, j| {
            let block = list.iter().find(|(row, _)| *row as usize == i / 3);
            match block {
                _ if i / 3 != j / 3 => 0.0,
                Some((_, q)) => q[i % 3][j % 3],
                None => f64::from(u8::from(i == j)),
            }
        })
    }

    #[test]
    fn blocks_with_constrained_directions_agree_with_dense_products() {
        let (coarse_n, fine_n) = (6, 13);
        let slanted = [[0.5, -0.5, 0.0], [-0.5, 0.5, 0.0], [0.0, 0.0, 1.0]];
        let axis = [[0.0; 3], [0.0, 1.0, 0.0], [0.0; 3]];
        let (fine_list, coarse_list) =
            (vec![(2, slanted), (7, axis)], vec![(0, axis), (3, slanted)]);
        let fine = Projectors::new(0, fine_n, fine_list.clone()).unwrap();
        let coarse = Projectors::new(1, coarse_n, coarse_list.clone()).unwrap();
        // F B F + 5 (I − F), B tridiagonal in blocks.
        let numbers = crate::noise(9 * fine_n, 8);
        let b = |i: usize, j: usize| {
            let (row, column) = (i.min(j), i.max(j));
            let near = column / 3 - row / 3 <= 1;
            if near { numbers[(31 * row + column) % (9 * fine_n)] } else { 0.0 }
        };
        let f = expanded(fine_n, &fine_list);
        let free_part = times(&times(&f, &dense(3 * fine_n, 3 * fine_n, b)), &f);
        let a = |i: usize, j: usize| {
            let identity = f64::from(u8::from(i == j));
            free_part[i][j] + 5.0 * (identity - f[i][j])
        };
        let pattern = second_difference(fine_n);
        let block =
            |i: usize, j: u32| -> Block { Entry::from_fn(|r, c| a(3 * i + r, 3 * j as usize + c)) };
        let blocks: Vec<Block> = (0..fine_n)
            .flat_map(|i| pattern.row(i).0.iter().map(move |&j| (i, j)))
            .map(|(i, j)| block(i, j))
            .collect();
        let matrix = pattern.with_values(blocks);

        let p = interpolation(coarse_n);
        let result = constrained_galerkin((&matrix, &fine), (&p, &transpose(&p)), &coarse, None);
        assert_eq!(transpose(&result), result, "symmetric to the last bit");
        let weight = |i: usize, j: usize| {
            if i % 3 == j % 3 { p.get(i / 3, j / 3).unwrap_or(0.0) } else { 0.0 }
        };
        let c = expanded(coarse_n, &coarse_list);
        let prolong = times(&times(&f, &dense(3 * fine_n, 3 * coarse_n, weight)), &c);
        let restrict = dense(3 * coarse_n, 3 * fine_n, |i, j| prolong[j][i]);
        let expected = times(&times(&restrict, &free_part), &prolong);
        for i in 0..3 * coarse_n {
            for j in 0..3 * coarse_n {
                // In the free directions; the others have only their own diagonal.
                let mut value = result.get(i / 3, j / 3).map_or(0.0, |block| block[i % 3][j % 3]);
                if i / 3 == j / 3 && coarse.get(i / 3).is_some() {
                    let block = result.get(i / 3, i / 3).unwrap();
                    let q = coarse.get(i / 3).unwrap();
                    value = q.times(block).times(*q)[i % 3][j % 3];
                }
                assert!((value - expected[i][j]).abs() < 1e-14, "{i} {j}");
            }
        }
        let fixed = result.get(0, 0).unwrap();
        assert!(fixed[0][0] > 0.0 && fixed[0][0] == fixed[2][2] && fixed[0][1] == 0.0);
    }
}
