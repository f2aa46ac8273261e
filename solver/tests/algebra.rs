//! Sparse kernels against dense references that are obviously right.

use octruss_solver::kernels::{add_product, product, product_dot, residual};
use octruss_solver::{Csr, galerkin, multiply, noise, transpose};
use proptest::prelude::*;

type Dense = Vec<Vec<f64>>;

/// A dense matrix with small integers, most of them zero: products are exact.
fn dense(rows: usize, columns: usize) -> impl Strategy<Value = Dense> {
    let entry = prop_oneof![3 => Just(0.0), 1 => (-4i32..5).prop_map(f64::from)];
    prop::collection::vec(prop::collection::vec(entry, columns), rows)
}

fn sparse(dense: &Dense, columns: usize) -> Csr<f64> {
    let (mut offsets, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
    for row in dense {
        for (j, &value) in row.iter().enumerate().filter(|(_, v)| **v != 0.0) {
            indices.push(j as u32);
            values.push(value);
        }
        offsets.push(indices.len());
    }
    Csr::new(columns, offsets, indices, values).unwrap()
}

fn to_dense(matrix: &Csr<f64>) -> Dense {
    let entry = |i: usize, j: usize| matrix.get(i, j).unwrap_or(0.0);
    (0..matrix.rows()).map(|i| (0..matrix.columns()).map(|j| entry(i, j)).collect()).collect()
}

fn dense_product(a: &Dense, b: &Dense, columns: usize) -> Dense {
    let entry = |row: &Vec<f64>, j: usize| row.iter().zip(b).map(|(v, b)| v * b[j]).sum();
    a.iter().map(|row| (0..columns).map(|j| entry(row, j)).collect()).collect()
}

fn dense_transpose(a: &Dense, columns: usize) -> Dense {
    (0..columns).map(|j| a.iter().map(|row| row[j]).collect()).collect()
}

proptest! {
    #[test]
    fn products_agree(
        (n, m, a, x) in (0usize..12, 0usize..12).prop_flat_map(|(n, m)| {
            let x = prop::collection::vec((-9i32..10).prop_map(f64::from), m);
            (Just(n), Just(m), dense(n, m), x)
        })
    ) {
        let matrix = sparse(&a, m);
        let expected: Vec<f64> =
            a.iter().map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
        let mut y = vec![1.0; n];
        product(&matrix, &x, &mut y);
        prop_assert_eq!(&y, &expected);
        add_product(&matrix, &x, &mut y);
        let twice: Vec<f64> = expected.iter().map(|v| 2.0 * v).collect();
        prop_assert_eq!(&y, &twice);
        let mut r = vec![0.0; n];
        residual(&matrix, &x, &twice, &mut r);
        prop_assert_eq!(&r, &expected);
        prop_assert_eq!(to_dense(&transpose(&matrix)), dense_transpose(&a, m));
        let mut single = vec![0f32; n];
        product(&matrix.cast::<f32>(), &x.iter().map(|v| *v as f32).collect::<Vec<_>>(), &mut single);
        prop_assert!(single.iter().zip(&expected).all(|(s, e)| f64::from(*s) == *e));
    }

    #[test]
    fn sparse_products_and_galerkin_products_agree(
        (n, m, a, p) in (1usize..12, 1usize..8)
            .prop_flat_map(|(n, m)| (Just(n), Just(m), dense(n, n), dense(n, m)))
    ) {
        // A + Aᵀ + diagonal: symmetric with its diagonal stored.
        let mut a = a;
        for i in 0..n {
            for j in 0..i {
                a[i][j] = a[j][i];
            }
            a[i][i] += 20.0;
        }
        let (sparse_a, sparse_p) = (sparse(&a, n), sparse(&p, m));
        let a_p = dense_product(&a, &p, m);
        prop_assert_eq!(to_dense(&multiply(&sparse_a, &sparse_p)), a_p.clone());
        let coarse = galerkin(&sparse_a, &sparse_p, &transpose(&sparse_p));
        let expected = dense_product(&dense_transpose(&p, m), &a_p, m);
        prop_assert_eq!(to_dense(&coarse), expected);
        prop_assert_eq!(transpose(&coarse), coarse);
    }
}

type Block = [[f64; 3]; 3];

/// The 3 × 3 blocks of a dense matrix, those that are zero left out.
fn blocks(dense: &Dense) -> Csr<Block> {
    let n = dense.len() / 3;
    let (mut offsets, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
    for i in 0..n {
        for j in 0..n {
            let block = [0, 1, 2].map(|r| [0, 1, 2].map(|c| dense[3 * i + r][3 * j + c]));
            if block != [[0.0; 3]; 3] {
                indices.push(j as u32);
                values.push(block);
            }
        }
        offsets.push(indices.len());
    }
    Csr::new(n, offsets, indices, values).unwrap()
}

proptest! {
    #[test]
    fn blocks_agree_with_their_numbers(
        (n, m, a, p, x) in (1usize..6, 1usize..4).prop_flat_map(|(n, m)| {
            let x = prop::collection::vec((-9i32..10).prop_map(f64::from), 3 * n);
            (Just(n), Just(m), dense(3 * n, 3 * n), dense(n, m), x)
        })
    ) {
        let mut a = a;
        for i in 0..3 * n {
            for j in 0..i {
                a[i][j] = a[j][i];
            }
        }
        let matrix = blocks(&a);
        let x_blocks: Vec<[f64; 3]> = x.as_chunks::<3>().0.to_vec();
        let mut y = vec![[0.0; 3]; n];
        product(&matrix, &x_blocks, &mut y);
        let expected: Vec<f64> =
            a.iter().map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
        prop_assert_eq!(y.as_flattened(), &expected);
        let mut single = vec![[0f32; 3]; n];
        let x_single: Vec<[f32; 3]> = x_blocks.iter().map(|x| x.map(|v| v as f32)).collect();
        product(&matrix.cast::<[[f32; 3]; 3]>(), &x_single, &mut single);
        prop_assert!(single.iter().zip(&y).all(|(s, y)| s.map(f64::from) == *y));

        // P acts on three components alike.
        let transfer = sparse(&p, m);
        let coarse = galerkin(&matrix, &transfer, &transpose(&transfer));
        prop_assert_eq!(transpose(&coarse), coarse.clone());
        let wide = |i: usize, j: usize| if i % 3 == j % 3 { p[i / 3][j / 3] } else { 0.0 };
        let wide: Dense = (0..3 * n).map(|i| (0..3 * m).map(|j| wide(i, j)).collect()).collect();
        let a_p = dense_product(&a, &wide, 3 * m);
        let expected = dense_product(&dense_transpose(&wide, 3 * m), &a_p, 3 * m);
        for (i, row) in expected.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                let block = coarse.get(i / 3, j / 3).unwrap_or_default();
                prop_assert_eq!(block[i % 3][j % 3], *value);
            }
        }
    }
}

/// A banded matrix long enough for many chunks.
fn banded(n: usize) -> Csr<f64> {
    let weights = noise(9 * n, 9);
    let (mut offsets, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
    for i in 0..n {
        for j in (i.saturating_sub(40)..n.min(i + 41)).step_by(10) {
            indices.push(j as u32);
            values.push(weights[values.len()]);
        }
        offsets.push(indices.len());
    }
    Csr::new(n, offsets, indices, values).unwrap()
}

#[test]
fn kernels_give_the_same_bits_for_any_number_of_threads() {
    let n = 50_000;
    let (a, x) = (banded(n), noise(n, 1));
    let results = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut y = vec![0.0; n];
            let dot = product_dot(&a, &x, &mut y);
            (dot.to_bits(), y, multiply(&a, &a))
        })
    });
    assert_eq!(results[0], results[1]);
    assert_eq!(results[0], results[2]);
}
