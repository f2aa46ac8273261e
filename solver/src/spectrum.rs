//! The largest eigenvalue of D⁻¹A.

use crate::csr::Csr;
use crate::dot::{dot, norm};
use crate::kernels::product;
use crate::random::noise;

/// Lanczos steps: the estimate then lies a few percent below the eigenvalue,
/// which the smoother's safety factor covers.
const STEPS: usize = 10;

/// An estimate from below of the largest eigenvalue of D⁻¹A for symmetric A,
/// never above the bound max Σ |a_ij| / a_ii; by ten Lanczos steps on
/// D^−½ A D^−½ from a fixed start vector.
pub(crate) fn largest_eigenvalue(matrix: &Csr<f64>, diagonal: &[f64]) -> f64 {
    let n = matrix.rows();
    let scale: Vec<f64> = diagonal.iter().map(|d| 1.0 / d.sqrt()).collect();
    let mut current = noise(n, 1);
    let mut previous = vec![0.0; n];
    let mut scaled = vec![0.0; n];
    let mut image = vec![0.0; n];
    let (mut alphas, mut betas) = (Vec::new(), Vec::new());
    let mut beta = norm(&current);
    while alphas.len() < STEPS.min(n) && beta > 1e-12 {
        current.iter_mut().for_each(|v| *v /= beta);
        for i in 0..n {
            scaled[i] = scale[i] * current[i];
        }
        product(matrix, &scaled, &mut image);
        for i in 0..n {
            image[i] *= scale[i];
        }
        let alpha = dot(&current, &image);
        if !alphas.is_empty() {
            betas.push(beta);
        }
        let back = if alphas.is_empty() { 0.0 } else { beta };
        for i in 0..n {
            image[i] -= alpha * current[i] + back * previous[i];
        }
        alphas.push(alpha);
        beta = norm(&image);
        std::mem::swap(&mut previous, &mut current);
        std::mem::swap(&mut current, &mut image);
    }
    let bound = row_bound(matrix, diagonal);
    largest_of_tridiagonal(&alphas, &betas, bound).min(bound)
}

/// max Σ_j |a_ij| / a_ii, which no eigenvalue of D⁻¹A exceeds.
fn row_bound(matrix: &Csr<f64>, diagonal: &[f64]) -> f64 {
    let row = |i: usize| matrix.row(i).1.iter().map(|v| v.abs()).sum::<f64>() / diagonal[i];
    crate::chunks::map_ranges(matrix.rows(), |rows| rows.map(row).fold(0.0, f64::max))
        .into_iter()
        .fold(0.0, f64::max)
}

/// The largest eigenvalue, at most `upper`, of the symmetric tridiagonal matrix
/// with these diagonals, by bisection: λ is above it exactly if all pivots of
/// λ − T are positive.
fn largest_of_tridiagonal(alphas: &[f64], betas: &[f64], upper: f64) -> f64 {
    let is_above = |lambda: f64| {
        let mut pivot = 1.0;
        alphas.iter().enumerate().all(|(k, alpha)| {
            let coupling = if k == 0 { 0.0 } else { betas[k - 1].powi(2) };
            pivot = lambda - alpha - coupling / pivot;
            pivot > 0.0
        })
    };
    let (mut below, mut above) = (0.0, upper);
    for _ in 0..40 {
        let middle = 0.5 * (below + above);
        if is_above(middle) { above = middle } else { below = middle }
    }
    above
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_difference_has_its_known_spectrum() {
        // D⁻¹A of the matrix (−1, 2, −1) with n rows: 1 + cos(π / (n + 1)).
        for n in [1usize, 2, 5, 10] {
            let a = crate::toy::second_difference(n);
            let exact = 1.0 + (std::f64::consts::PI / (n as f64 + 1.0)).cos();
            assert!((largest_eigenvalue(&a, &vec![2.0; n]) - exact).abs() < 1e-9);
        }
        let a = crate::toy::second_difference(4000);
        let estimate = largest_eigenvalue(&a, &vec![2.0; 4000]);
        assert!(estimate > 1.9 && estimate <= 2.0, "{estimate}");
    }
}
