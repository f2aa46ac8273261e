//! The largest eigenvalue of D⁻¹A.

use crate::krylov::operator::Operator;
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::noise::noise;
use crate::sparse::real::Real;
use octruss_base::chunks::{for_chunks, map_chunks};
use octruss_base::large_array::zeroed;

/// Lanczos steps: the estimate then lies a few percent below the eigenvalue,
/// which the smoother's safety factor covers.
const STEPS: usize = 10;

/// A new direction of this length, beside vectors of length 1, is rounding.
const EXHAUSTED: f64 = 1e-6;

/// Where the spectrum of D⁻¹A ends.
#[derive(Clone, Copy)]
pub(crate) struct UpperEnd {
    /// From below, within a few percent.
    pub(crate) estimate: f64,
    /// No eigenvalue is larger; infinite where the operator knows no bound.
    pub(crate) bound: f64,
}

/// The largest eigenvalue of D⁻¹A for symmetric A and D its diagonal (blocks): ten
/// Lanczos steps in the scalar product of D, from a fixed start vector, and a bound
/// from the rows. Single precision is enough.
///
/// In that product every row of the start vector weighs about as much: it is noise over
/// the square root of the diagonal. With mere noise a soft material beside a hard one
/// would hardly count, and what is largest there be seen too late.
pub(crate) fn largest_eigenvalue<E: Entry>(
    matrix: &impl Operator<E>,
    diagonal: &[E],
    inverse_diagonal: &[E],
) -> UpperEnd {
    let n = matrix.rows();
    let zero = E::Nodal::default();
    let round = E::Real::from_f64;
    let [mut previous, mut current, mut next] = std::array::from_fn(|_| zeroed(n));
    let start = noise(n * E::Nodal::SIZE, 1);
    E::Nodal::flat_mut(&mut current).iter_mut().zip(start).for_each(|(v, s)| *v = round(s));
    for_chunks(&mut current, |first, chunk| {
        for (v, diagonal) in chunk.iter_mut().zip(&diagonal[first..]) {
            *v = v.scaled(round(1.0 / diagonal.norm().sqrt()));
        }
    });
    let weighted = |first: usize, chunk: &[E::Nodal]| weighted_square(chunk, &diagonal[first..]);
    let sums = map_chunks(&mut current, |first, chunk| weighted(first, chunk));
    let mut size = sums.iter().sum::<f64>().sqrt();
    let (mut alphas, mut betas) = (Vec::new(), Vec::new());
    for step in 0..STEPS.min(n * E::Nodal::SIZE) {
        for_chunks(&mut current, |_, chunk| {
            chunk.iter_mut().for_each(|v| *v = v.scaled(round(1.0 / size)));
        });
        let alpha = matrix.product_dot(&current, &mut next);
        if step > 0 {
            betas.push(size);
        }
        alphas.push(alpha);
        let sums = map_chunks(&mut next, |first, chunk| {
            for (k, v) in chunk.iter_mut().enumerate() {
                let i = first + k;
                let scaled = inverse_diagonal[i].add_product(*v, zero);
                let without = scaled.add_scaled(round(-alpha), current[i]);
                *v = without.add_scaled(round(-size), previous[i]);
            }
            weighted(first, chunk)
        });
        size = sums.iter().sum::<f64>().sqrt();
        // Nothing new is left: the space is invariant, the estimate exact.
        if size < EXHAUSTED {
            break;
        }
        std::mem::swap(&mut previous, &mut current);
        std::mem::swap(&mut current, &mut next);
    }
    let bound = matrix.bound(inverse_diagonal);
    let upper = bound.unwrap_or_else(|| largest_row(&alphas, &betas));
    let bound = bound.unwrap_or(f64::INFINITY);
    UpperEnd { estimate: largest_of_tridiagonal(&alphas, &betas, upper).min(upper), bound }
}

/// Σ v_i · D_i v_i.
fn weighted_square<E: Entry>(v: &[E::Nodal], d: &[E]) -> f64 {
    let square = |(v, d): (&E::Nodal, &E)| {
        let image = d.add_product(*v, E::Nodal::default());
        (0..E::Nodal::SIZE).map(|k| v.at(k).to_f64() * image.at(k).to_f64()).sum::<f64>()
    };
    v.iter().zip(d).map(square).sum()
}

/// The largest sum of absolute values in a row of the symmetric tridiagonal matrix with
/// these diagonals, which none of its eigenvalues exceeds.
fn largest_row(alphas: &[f64], betas: &[f64]) -> f64 {
    let beside = |k: usize| betas.get(k).map_or(0.0, |beta| beta.abs());
    let row = |k: usize| alphas[k].abs() + beside(k) + if k > 0 { beside(k - 1) } else { 0.0 };
    (0..alphas.len()).map(row).fold(0.0, f64::max)
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
    use crate::sparse::csr::Csr;

    #[test]
    fn the_second_difference_has_its_known_spectrum() {
        // D⁻¹A of the matrix (−1, 2, −1) with n rows: 1 + cos(π / (n + 1)).
        for n in [1usize, 2, 5, 10] {
            let a = crate::toy::second_difference(n);
            let exact = 1.0 + (std::f64::consts::PI / (n as f64 + 1.0)).cos();
            let end = largest_eigenvalue(&a, &vec![2.0; n], &vec![0.5; n]);
            assert!((end.estimate - exact).abs() < 1e-9);
            // Rows sum to (1 + 2 + 1) / 2, at the ends and for short chains less.
            assert_eq!(end.bound, [1.0, 1.5, 2.0][n.min(3) - 1]);
        }
        let a = crate::toy::second_difference(4000);
        let estimate = largest_eigenvalue(&a, &vec![2.0; 4000], &vec![0.5; 4000]).estimate;
        assert!(estimate > 1.9 && estimate <= 2.0, "{estimate}");
    }

    #[test]
    fn what_is_largest_in_a_soft_part_is_seen() {
        // Pairs (1, c; c, 1) have 1 ± c. Soft ones have c up to 0.6, others, 10¹²
        // times as stiff, up to 0.4.
        let (pairs, soft) = (2000, 1000);
        let size = |i: usize| if i / 2 < soft { 1.0 } else { 1e12 };
        let coupling = |i: usize| {
            let pair = i / 2;
            let share = (pair % soft) as f64 / soft as f64;
            size(i) * share * if pair < soft { 0.6 } else { 0.4 }
        };
        let offsets = (0..=2 * pairs).map(|i| 2 * i).collect();
        let indices = (0..2 * pairs as u32).flat_map(|i| [i & !1, i | 1]).collect();
        let values = (0..2 * pairs).flat_map(|i| match i % 2 {
            0 => [size(i), coupling(i)],
            _ => [coupling(i), size(i)],
        });
        let a = Csr::new(2 * pairs, offsets, indices, values.collect()).unwrap();
        let diagonal: Vec<f64> = (0..2 * pairs).map(size).collect();
        let inverses: Vec<f64> = diagonal.iter().map(|d| 1.0 / d).collect();
        let estimate = largest_eigenvalue(&a, &diagonal, &inverses).estimate;
        assert!(estimate > 1.57 && estimate < 1.6, "{estimate}");
    }
}
