//! The passes over a sparse matrix, each fused with what follows it.
//!
//! All are limited by memory. A pass over n rows with m entries must read at
//! least 12 m bytes (8 m in single precision; blocks 76 m and 40 m) and the
//! vectors once; everything that can be done with a row's sum while it is in a
//! register is done there.

use crate::sparse::csr::Csr;
use crate::sparse::dot::chunk_dot;
use crate::sparse::entry::{Acts, Entry, Nodal};
use octruss_base::chunks::{for_chunks, map_chunks, map_chunks2};

/// The product of a row with `x`, in four partial sums so that additions overlap.
/// Always inlined: a call for each row would cost a tenth of the time.
#[inline(always)]
pub(crate) fn row_product<A: Acts<V>, V: Nodal>((indices, values): (&[u32], &[A]), x: &[V]) -> V {
    let (i4, i_rest) = indices.as_chunks::<4>();
    let (v4, v_rest) = values.as_chunks::<4>();
    let mut sums = [V::default(); 4];
    for (index, value) in i4.iter().zip(v4) {
        for k in 0..4 {
            sums[k] = value[k].add_product(x[index[k] as usize], sums[k]);
        }
    }
    let mut rest = V::default();
    for (&j, &v) in i_rest.iter().zip(v_rest) {
        rest = v.add_product(x[j as usize], rest);
    }
    (sums[0].plus(sums[1])).plus(sums[2].plus(sums[3])).plus(rest)
}

/// y = A x.
///
/// # Panics
/// Here and below: if a vector's length does not fit the matrix.
pub fn product<A: Acts<V>, V: Nodal>(matrix: &Csr<A>, x: &[V], y: &mut [V]) {
    check_lengths(matrix, x, y);
    for_chunks(y, |first, chunk| product_rows(matrix, x, first, chunk));
}

/// The rows of y = A x from row `first` on.
fn product_rows<A: Acts<V>, V: Nodal>(matrix: &Csr<A>, x: &[V], first: usize, y: &mut [V]) {
    for (row, y) in matrix.rows_in(first..first + y.len()).zip(y) {
        *y = row_product(row, x);
    }
}

/// y += A x.
pub fn add_product<A: Acts<V>, V: Nodal>(matrix: &Csr<A>, x: &[V], y: &mut [V]) {
    check_lengths(matrix, x, y);
    for_chunks(y, |first, chunk| {
        for (row, y) in matrix.rows_in(first..first + chunk.len()).zip(chunk) {
            *y = y.plus(row_product(row, x));
        }
    });
}

/// r = b − A x.
pub fn residual<A: Acts<V>, V: Nodal>(matrix: &Csr<A>, x: &[V], b: &[V], r: &mut [V]) {
    check_lengths(matrix, x, r);
    assert_eq!(b.len(), r.len());
    for_chunks(r, |first, chunk| {
        let rows = first..first + chunk.len();
        for ((row, b), r) in matrix.rows_in(rows.clone()).zip(&b[rows]).zip(chunk) {
            *r = b.minus(row_product(row, x));
        }
    });
}

/// y = A x for a square matrix, and x · y.
pub fn product_dot<E: Entry>(matrix: &Csr<E>, x: &[E::Nodal], y: &mut [E::Nodal]) -> f64 {
    check_lengths(matrix, x, y);
    assert_eq!(x.len(), y.len());
    let sums = map_chunks(y, |first, chunk| {
        product_rows(matrix, x, first, chunk);
        chunk_dot(Nodal::flat(chunk), Nodal::flat(&x[first..first + chunk.len()]))
    });
    sums.iter().sum()
}

/// One Chebyshev step, d ← `keep` d + `add` D⁻¹ (b − A x), next = x + d: what it reads
/// and what it writes, an entry for each row.
pub struct ChebyshevStep<'a, E: Entry> {
    /// The inverse of the diagonal D.
    pub inverse_diagonal: &'a [E],
    /// The share of the last direction.
    pub keep: E::Real,
    /// The share of the scaled residual.
    pub add: E::Real,
    /// The right-hand side.
    pub b: &'a [E::Nodal],
    /// The iterate.
    pub x: &'a [E::Nodal],
    /// The direction, the last one and then the new.
    pub d: &'a mut [E::Nodal],
    /// The new iterate, whatever it held.
    pub next: &'a mut [E::Nodal],
}

/// Does a Chebyshev step with the residual inside the product's loop.
pub fn chebyshev_step<E: Entry>(matrix: &Csr<E>, step: ChebyshevStep<E>) {
    let ChebyshevStep { inverse_diagonal, keep, add, b, x, d, next } = step;
    check_lengths(matrix, x, d);
    map_chunks2(d, next, |first, d, next| {
        let rows = first..first + d.len();
        let given = b[rows.clone()].iter().zip(&x[rows.clone()]);
        let given = given.zip(&inverse_diagonal[rows.clone()]);
        let rows = matrix.rows_in(rows).zip(given);
        for ((row, ((b, x_here), inverse)), (d, next)) in rows.zip(d.iter_mut().zip(next)) {
            let r = b.minus(row_product(row, x));
            let scaled = inverse.add_product(r, E::Nodal::default());
            *d = d.scaled(keep).add_scaled(add, scaled);
            *next = x_here.plus(*d);
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

fn check_lengths<A: Copy, V>(matrix: &Csr<A>, x: &[V], y: &[V]) {
    assert_eq!(matrix.columns(), x.len(), "one entry of x for each column");
    assert_eq!(matrix.rows(), y.len(), "one entry of y for each row");
}
