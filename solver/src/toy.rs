//! One-dimensional matrices with known answers, for tests.

use crate::sparse::csr::Csr;

/// The n × n matrix (−1, 2, −1).
pub(crate) fn second_difference(n: usize) -> Csr<f64> {
    tridiagonal(n, -1.0, 2.0)
}

/// The n × n matrix (off, diagonal, off).
pub(crate) fn tridiagonal(n: usize, off: f64, diagonal: f64) -> Csr<f64> {
    let (mut offsets, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
    for i in 0..n {
        for j in i.saturating_sub(1)..(i + 2).min(n) {
            indices.push(j as u32);
            values.push(if i == j { diagonal } else { off });
        }
        offsets.push(indices.len());
    }
    Csr::new(n, offsets, indices, values).unwrap()
}

/// Linear interpolation from n to 2 n + 1 interior points of an interval.
pub(crate) fn interpolation(n: usize) -> Csr<f64> {
    let (mut offsets, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
    for i in 0..2 * n + 1 {
        // Fine point i lies on coarse point (i − 1) / 2 or between two of them.
        let parents = if i % 2 == 1 {
            vec![(i / 2, 1.0)]
        } else {
            let ends = [(i / 2).checked_sub(1), Some(i / 2).filter(|&j| j < n)];
            ends.into_iter().flatten().map(|j| (j, 0.5)).collect()
        };
        for (j, weight) in parents {
            indices.push(j as u32);
            values.push(weight);
        }
        offsets.push(indices.len());
    }
    Csr::new(n, offsets, indices, values).unwrap()
}
