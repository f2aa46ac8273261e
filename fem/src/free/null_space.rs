//! Vectors that a matrix maps to zero.

use nalgebra::{DMatrix, DVector};
use octruss_base::chunks::map_ranges;
use octruss_solver::Nodal;

/// What a matrix maps to zero, an orthonormal basis for each part of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct NullSpace<V> {
    parts: Vec<Basis<V>>,
}

/// Orthonormal vectors that are zero but in these rows.
#[derive(Debug, Clone, PartialEq)]
struct Basis<V> {
    rows: Vec<u32>,
    vectors: Vec<Vec<V>>,
}

impl<V: Nodal<Real = f64>> NullSpace<V> {
    /// From the rows of each part, none in two of them, and independent vectors with a value
    /// for each of these rows.
    pub(crate) fn new(parts: impl IntoIterator<Item = (Vec<u32>, Vec<Vec<V>>)>) -> Self {
        let basis = |(rows, vectors): (Vec<u32>, Vec<Vec<V>>)| Basis {
            rows,
            vectors: orthonormal(vectors),
        };
        Self { parts: parts.into_iter().map(basis).collect() }
    }

    /// How many independent vectors there are.
    pub fn dimension(&self) -> usize {
        self.parts.iter().map(|part| part.vectors.len()).sum()
    }

    /// Takes out of a vector what is in the null space: its orthogonal projection onto the
    /// rest, which is the range of a symmetric matrix.
    pub fn project(&self, x: &mut [V]) {
        for Basis { rows, vectors } in &self.parts {
            for vector in vectors {
                let share = gathered(rows, |k, row| dot(vector[k], x[row]));
                add_at(rows, vector, -share, x);
            }
        }
    }

    /// Takes out of a vector what is in the null space so that what is left is orthogonal to
    /// these `means`, of which each part uses as many as it has vectors.
    pub(crate) fn centre(&self, means: &[Vec<V>], x: &mut [V]) {
        for Basis { rows, vectors } in &self.parts {
            let count = vectors.len();
            let matrix = DMatrix::from_fn(count, count, |i, j| {
                gathered(rows, |k, row| dot(means[i][row], vectors[j][k]))
            });
            let mean = |i: usize, _| gathered(rows, |_, row| dot(means[i][row], x[row]));
            let rest = DVector::from_fn(count, mean);
            // Singular only where the means have no weight: nothing is to be taken out there.
            let Some(shares) = matrix.lu().solve(&rest) else { continue };
            for (vector, share) in vectors.iter().zip(shares.iter()) {
                add_at(rows, vector, -share, x);
            }
        }
    }
}

/// Gram and Schmidt's method, done twice.
fn orthonormal<V: Nodal<Real = f64>>(mut vectors: Vec<Vec<V>>) -> Vec<Vec<V>> {
    for k in 0..vectors.len() {
        let (done, rest) = vectors.split_at_mut(k);
        let vector = &mut rest[0];
        for _ in 0..2 {
            for other in &*done {
                let share = octruss_solver::dot(other, vector);
                vector.iter_mut().zip(other).for_each(|(x, y)| *x = x.add_scaled(-share, *y));
            }
            let length = octruss_solver::norm(vector);
            vector.iter_mut().for_each(|x| *x = x.scaled(1.0 / length));
        }
    }
    vectors
}

fn dot<V: Nodal<Real = f64>>(a: V, b: V) -> f64 {
    (0..V::SIZE).map(|k| a.at(k) * b.at(k)).sum()
}

/// The sum over places and their rows, chunk by chunk.
fn gathered(rows: &[u32], value: impl Fn(usize, usize) -> f64 + Sync) -> f64 {
    let sum =
        |range: std::ops::Range<usize>| -> f64 { range.map(|k| value(k, rows[k] as usize)).sum() };
    map_ranges(rows.len(), sum).into_iter().sum()
}

fn add_at<V: Nodal<Real = f64>>(rows: &[u32], vector: &[V], factor: f64, x: &mut [V]) {
    for (&row, value) in rows.iter().zip(vector) {
        x[row as usize] = x[row as usize].add_scaled(factor, *value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two parts of three rows each, in turn.
    fn null_space() -> NullSpace<f64> {
        let ones = vec![1.0; 3];
        NullSpace::new([
            (vec![0, 2, 4], vec![ones.clone(), vec![0.0, 1.0, 2.0]]),
            (vec![1, 3, 5], vec![ones]),
        ])
    }

    #[test]
    fn each_part_loses_its_own_vectors() {
        let null_space = null_space();
        assert_eq!(null_space.dimension(), 3);
        let mut x = [1.0, 10.0, 5.0, 20.0, 3.0, 30.0];
        null_space.project(&mut x);
        // 1, 5, 3 less their straight line 2, 3, 4.
        let exact = [-1.0, -10.0, 2.0, 0.0, -1.0, 10.0];
        assert!(x.iter().zip(exact).all(|(x, exact)| (x - exact).abs() < 1e-14), "{x:?}");
    }

    #[test]
    fn weights_count_in_the_mean() {
        let mut x = [0.0, 1.0, 0.0, 2.0, 0.0, 3.0];
        let means = [vec![1.0, 1.0, 1.0, 1.0, 1.0, 2.0], vec![0.0, 0.0, 1.0, 0.0, 3.0, 0.0]];
        null_space().centre(&means, &mut x);
        // (1 + 2 + 2 · 3) / 4 = 2.25.
        let exact = [0.0, -1.25, 0.0, -0.25, 0.0, 0.75];
        assert!(x.iter().zip(exact).all(|(x, exact)| (x - exact).abs() < 1e-14), "{x:?}");
    }
}
