//! The passes over a sparse matrix, each fused with what follows it.
//!
//! All are limited by memory. A pass over n rows with m entries must read at
//! least 12 m bytes (8 m in single precision) and the vectors once; everything
//! that can be done with a row's sum while it is in a register is done there.

use crate::chunks::{for_chunks, map_chunks, map_chunks2};
use crate::csr::Csr;
use crate::dot::chunk_dot;
use crate::real::Real;

/// The product of row `i` with `x`, in four partial sums so that additions
/// overlap.
#[inline]
pub(crate) fn row_product<T: Real>(matrix: &Csr<T>, i: usize, x: &[T]) -> T {
    let (indices, values) = matrix.row(i);
    let (i4, i_rest) = indices.as_chunks::<4>();
    let (v4, v_rest) = values.as_chunks::<4>();
    let mut sums = [T::default(); 4];
    for (index, value) in i4.iter().zip(v4) {
        for k in 0..4 {
            sums[k] += value[k] * x[index[k] as usize];
        }
    }
    let mut rest = T::default();
    for (&j, &v) in i_rest.iter().zip(v_rest) {
        rest += v * x[j as usize];
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// y = A x.
///
/// # Panics
/// Here and below: if a vector's length does not fit the matrix.
pub fn product<T: Real>(matrix: &Csr<T>, x: &[T], y: &mut [T]) {
    check_lengths(matrix, x, y);
    for_chunks(y, |first, chunk| {
        for (k, y) in chunk.iter_mut().enumerate() {
            *y = row_product(matrix, first + k, x);
        }
    });
}

/// y += A x.
pub fn add_product<T: Real>(matrix: &Csr<T>, x: &[T], y: &mut [T]) {
    check_lengths(matrix, x, y);
    for_chunks(y, |first, chunk| {
        for (k, y) in chunk.iter_mut().enumerate() {
            *y += row_product(matrix, first + k, x);
        }
    });
}

/// r = b − A x.
pub fn residual<T: Real>(matrix: &Csr<T>, x: &[T], b: &[T], r: &mut [T]) {
    check_lengths(matrix, x, r);
    assert_eq!(b.len(), r.len());
    for_chunks(r, |first, chunk| {
        for (k, r) in chunk.iter_mut().enumerate() {
            *r = b[first + k] - row_product(matrix, first + k, x);
        }
    });
}

/// y = A x for a square matrix, and x · y.
pub fn product_dot(matrix: &Csr<f64>, x: &[f64], y: &mut [f64]) -> f64 {
    check_lengths(matrix, x, y);
    assert_eq!(x.len(), y.len());
    let sums = map_chunks(y, |first, chunk| {
        for (k, y) in chunk.iter_mut().enumerate() {
            *y = row_product(matrix, first + k, x);
        }
        chunk_dot(chunk, &x[first..first + chunk.len()])
    });
    sums.iter().sum()
}

/// One Chebyshev step with the residual inside the product's loop:
/// d ← `keep` d + `add` D⁻¹ (b − A x), next = x + d.
pub(crate) fn chebyshev_step<T: Real>(
    (matrix, inverse_diagonal): (&Csr<T>, &[T]),
    (keep, add): (T, T),
    (x, b): (&[T], &[T]),
    (d, next): (&mut [T], &mut [T]),
) {
    check_lengths(matrix, x, d);
    map_chunks2(d, next, |first, d, next| {
        for (k, (d, next)) in d.iter_mut().zip(next).enumerate() {
            let i = first + k;
            let r = b[i] - row_product(matrix, i, x);
            *d = keep * *d + add * (inverse_diagonal[i] * r);
            *next = x[i] + *d;
        }
    });
}

/// x += a p, r −= a q, and r · r after it, in one pass.
pub(crate) fn advance(a: f64, (p, q): (&[f64], &[f64]), x: &mut [f64], r: &mut [f64]) -> f64 {
    let sums = map_chunks2(x, r, |first, x, r| {
        let here = first..first + x.len();
        for ((x, r), (p, q)) in x.iter_mut().zip(&mut *r).zip(p[here.clone()].iter().zip(&q[here]))
        {
            *x += a * p;
            *r -= a * q;
        }
        chunk_dot(r, r)
    });
    sums.iter().sum()
}

fn check_lengths<T: Real>(matrix: &Csr<T>, x: &[T], y: &[T]) {
    assert_eq!(matrix.columns(), x.len(), "one entry of x for each column");
    assert_eq!(matrix.rows(), y.len(), "one entry of y for each row");
}
