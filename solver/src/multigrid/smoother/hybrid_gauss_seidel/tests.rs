//! Sweeps against the splitting of a dense matrix.

use super::*;
use crate::sparse::noise::noise;

const ROWS: usize = 150;

type Dense = Vec<Vec<f64>>;

/// Rows up to 20 apart coupled by noise, the diagonal from seven tenths of all couplings of
/// its row together.
fn matrix<E: Entry<Real = f64>>() -> Csr<E> {
    let numbers = noise(9 * 21 * ROWS, 17);
    let coupling = |i: usize, j: usize| -> E {
        let at = 9 * (21 * i.min(j) + i.abs_diff(j));
        let entry = E::from_fn(|row, column| numbers[at + 3 * row + column]);
        if i < j { entry } else { entry.transposed() }
    };
    let near = |i: usize| (i.saturating_sub(20)..ROWS.min(i + 21)).filter(move |j| *j != i);
    let (mut offsets, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
    for i in 0..ROWS {
        let sum: f64 = near(i).map(|j| coupling(i, j).norm()).sum();
        for j in i.saturating_sub(20)..ROWS.min(i + 21) {
            indices.push(j as u32);
            // Stretched differently along the axes, and full.
            let diagonal = E::from_fn(|row, column| {
                let off = 0.05 * sum;
                if row == column { (0.7 + 0.3 * row as f64) * sum } else { off }
            });
            values.push(if i == j { diagonal } else { coupling(i, j) });
        }
        offsets.push(indices.len());
    }
    Csr::new(ROWS, offsets, indices, values).unwrap()
}

/// Domains of two runs each, neighbours rarely in the same.
fn domains() -> Domains {
    Domains::of_size(32, ROWS, |row| Some(vec![(row / 16 % 3) as u32]))
}

fn dense<E: Entry<Real = f64>>(matrix: &Csr<E>) -> Dense {
    let at = |i: usize, j: usize| {
        let entry = matrix.get(i / E::SIZE, j / E::SIZE).unwrap_or_default();
        entry.at(i % E::SIZE, j % E::SIZE)
    };
    let n = ROWS * E::SIZE;
    (0..n).map(|i| (0..n).map(|j| at(i, j)).collect()).collect()
}

/// L + D, with D enlarged where couplings to other domains need it.
fn lower<E: Entry<Real = f64>>(matrix: &Csr<E>) -> Dense {
    let mut domain_of = [0; ROWS];
    for (domain, ranges) in domains().ranges().iter().enumerate() {
        ranges.iter().cloned().flatten().for_each(|row| domain_of[row] = domain);
    }
    let growth = |i: usize| {
        let inverse = matrix.get(i, i).unwrap().inverse().unwrap();
        let outer = (0..ROWS).filter(|j| domain_of[*j] != domain_of[i]);
        let norms = outer.filter_map(|j| matrix.get(i, j)).map(|v| inverse.times(v).norm());
        (0.5 * (1.0 + norms.sum::<f64>() / 0.95)).max(1.0)
    };
    let growth: Vec<f64> = (0..ROWS).map(growth).collect();
    let sizes = growth.iter().fold([f64::MAX, 0.0_f64], |[a, b], g| [a.min(*g), b.max(*g)]);
    assert!(sizes[0] == 1.0 && sizes[1] > 1.0, "{sizes:?}");
    let mut lower = dense(matrix);
    for (i, row) in lower.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            let (i, j) = (i / E::SIZE, j / E::SIZE);
            *value *= match i.cmp(&j) {
                std::cmp::Ordering::Less => 0.0,
                std::cmp::Ordering::Equal => growth[i],
                std::cmp::Ordering::Greater => f64::from(u8::from(domain_of[i] == domain_of[j])),
            };
        }
    }
    lower
}

/// M⁻¹ b, or M⁻ᵀ b, by elimination: M is lower but for blocks on its diagonal.
fn solve(m: &Dense, b: &[f64], is_transposed: bool) -> Vec<f64> {
    let n = b.len();
    let mut a: Dense = (0..n)
        .map(|i| (0..n).map(|j| if is_transposed { m[j][i] } else { m[i][j] }).collect())
        .collect();
    let mut x = b.to_vec();
    for k in 0..n {
        let pivot = a[k].clone();
        for i in (0..n).filter(|i| *i != k) {
            let factor = a[i][k] / pivot[k];
            a[i].iter_mut().zip(&pivot).for_each(|(a, p)| *a -= factor * p);
            x[i] -= factor * x[k];
        }
    }
    (0..n).map(|i| x[i] / a[i][i]).collect()
}

fn residual(a: &Dense, b: &[f64], x: &[f64]) -> Vec<f64> {
    let product = |row: &Vec<f64>| row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
    a.iter().zip(b).map(|(row, b)| b - product(row)).collect()
}

fn agrees(ours: &[f64], exact: &[f64]) {
    let size = exact.iter().fold(0.0, |size: f64, v| size.max(v.abs()));
    let off = ours.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= 1e-12 * size, "{off} of {size}");
}

/// Sweeps before the correction, from zero and from elsewhere, and two after it, against
/// the splitting of the dense matrix.
fn sweeps_are_those_of_the_splitting<E: Entry<Real = f64>>() {
    let matrix = matrix::<E>();
    let diagonal = Diagonal::new(&matrix, 0).unwrap();
    let scale = 0.25;
    let mut ours = HybridGaussSeidel::<E>::new((&matrix, &diagonal, scale), domains());
    assert!(ours.parts.len() > 3);
    let scaled = |dense: Dense| -> Dense {
        dense.iter().map(|row| row.iter().map(|v| scale * v).collect()).collect()
    };
    let (a, m) = (scaled(dense(&matrix)), scaled(lower(&matrix)));
    let n = ROWS * E::SIZE;
    let nodal = |numbers: &[f64]| -> Vec<E::Nodal> {
        numbers.chunks(E::SIZE).map(|own| E::Nodal::from_fn(|k| own[k])).collect()
    };
    let b = noise(n, 3);
    for (sweeps, start) in
        [(1, None), (3, None), (0, None), (2, Some(noise(n, 4))), (0, Some(noise(n, 4)))]
    {
        let mut exact = start.clone().unwrap_or(vec![0.0; n]);
        // From zero whatever is there.
        let mut x = nodal(&start.clone().unwrap_or(vec![7.0; n]));
        let mut r = nodal(&vec![7.0; n]);
        ours.before(sweeps, (&nodal(&b), &mut x), start.is_none(), &mut r);
        let step = |exact: &mut Vec<f64>, is_transposed: bool| {
            let correction = solve(&m, &residual(&a, &b, exact), is_transposed);
            exact.iter_mut().zip(correction).for_each(|(x, c)| *x += c);
        };
        (0..sweeps).for_each(|_| step(&mut exact, false));
        agrees(Nodal::flat(&x), &exact);
        agrees(Nodal::flat(&r), &residual(&a, &b, &exact));
        ours.after(2, &nodal(&b), &mut x);
        (0..2).for_each(|_| step(&mut exact, true));
        agrees(Nodal::flat(&x), &exact);
    }
}

#[test]
fn sweeps_of_numbers_and_blocks_are_those_of_the_splitting() {
    sweeps_are_those_of_the_splitting::<f64>();
    sweeps_are_those_of_the_splitting::<[[f64; 3]; 3]>();
}

#[test]
fn sweeps_reduce_every_error_however_strongly_domains_are_coupled() {
    // All entries equal: every row is coupled as strongly to its own domain as to
    // others, and the smallest eigenvalues are small.
    let n = 64;
    let values = (0..n * n).map(|k| if k % (n + 1) == 0 { 1.01 } else { 1.0 }).collect();
    let offsets = (0..=n).map(|i| i * n).collect();
    let indices = (0..n * n).map(|k| (k % n) as u32).collect();
    let matrix = Csr::new(n, offsets, indices, values).unwrap();
    let diagonal = Diagonal::new(&matrix, 0).unwrap();
    let domains = Domains::of_size(16, n, |row| Some(vec![row as u32]));
    let mut ours = HybridGaussSeidel::<f64>::new((&matrix, &diagonal, 1.0), domains);
    let mut error = noise(n, 5);
    let energy = |error: &[f64]| {
        let mut image = vec![0.0; n];
        crate::sparse::kernels::product_dot(&matrix, error, &mut image).sqrt()
    };
    for _ in 0..20 {
        let before = energy(&error);
        ours.after(1, &vec![0.0; n], &mut error);
        assert!(energy(&error) < before);
    }
}
