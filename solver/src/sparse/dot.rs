//! Sums with the same bits for any number of threads: each fixed chunk is
//! summed by itself, the chunk sums are added in order.

use crate::sparse::entry::Nodal;
use crate::sparse::real::Real;
use octruss_base::chunks::map_ranges;

/// The scalar product of two vectors of equal length.
///
/// # Panics
/// If the lengths differ.
pub fn dot<V: Nodal<Real = f64>>(a: &[V], b: &[V]) -> f64 {
    assert_eq!(a.len(), b.len());
    let (a, b) = (V::flat(a), V::flat(b));
    map_ranges(a.len(), |range| chunk_dot(&a[range.clone()], &b[range])).iter().sum()
}

/// The Euclidean norm.
pub fn norm<V: Nodal<Real = f64>>(a: &[V]) -> f64 {
    dot(a, a).sqrt()
}

/// The largest absolute value, 0 for an empty vector.
pub(crate) fn largest<V: Nodal<Real = f64>>(a: &[V]) -> f64 {
    let a = V::flat(a);
    map_ranges(a.len(), |range| a[range].iter().fold(0.0_f64, |m, v| m.max(v.abs())))
        .into_iter()
        .fold(0.0, f64::max)
}

/// The scalar product inside one chunk, with four partial sums so that the
/// additions need not wait for each other; in the precision of the numbers.
#[inline]
pub(crate) fn chunk_dot<T: Real>(a: &[T], b: &[T]) -> f64 {
    let mut sums = [T::default(); 4];
    let (a4, a_rest) = a.as_chunks::<4>();
    let (b4, b_rest) = b.as_chunks::<4>();
    for (a, b) in a4.iter().zip(b4) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    let mut rest = T::default();
    for (a, b) in a_rest.iter().zip(b_rest) {
        rest += *a * *b;
    }
    ((sums[0] + sums[1]) + (sums[2] + sums[3]) + rest).to_f64()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_and_short_products_agree_with_closed_forms() {
        for n in [0usize, 1, 7, 2_999, 3_000, 100_003] {
            let a: Vec<f64> = (0..n).map(|i| i as f64).collect();
            let ones = vec![1.0; n];
            let exact = (n * n.saturating_sub(1) / 2) as f64;
            assert_eq!(dot(&a, &ones), exact, "integers below 2^53 add exactly");
        }
        assert_eq!(norm(&[3.0, 4.0]), 5.0);
        assert_eq!(largest(&[1.0, -7.0, 2.0]), 7.0);
    }
}
