//! What a sparse matrix holds at a place, and a vector for a row: a number, or
//! a 3 × 3 block and three numbers.
//!
//! All algorithms of this crate are written once over these traits. Prolongations
//! stay matrices of numbers in both cases: a number acts on three numbers too.

use crate::sparse::real::Real;
use std::fmt::Debug;

/// What a vector holds for each row: a number, or three (a displacement).
pub trait Nodal: Copy + Debug + Default + PartialEq + Send + Sync + 'static {
    /// Its precision.
    type Real: Real;
    /// How many numbers it is.
    const SIZE: usize;

    /// From its numbers, each rounded.
    fn from_fn(number: impl FnMut(usize) -> f64) -> Self;
    /// Its number `k`.
    fn at(&self, k: usize) -> Self::Real;
    /// A vector from its numbers, row by row, each rounded; what is left of a row is dropped.
    fn from_flat(numbers: &[f64]) -> Vec<Self> {
        numbers.chunks_exact(Self::SIZE).map(|row| Self::from_fn(|k| row[k])).collect()
    }
    /// All numbers of a vector, row by row.
    fn flat(values: &[Self]) -> &[Self::Real];
    /// All numbers of a vector, row by row.
    fn flat_mut(values: &mut [Self]) -> &mut [Self::Real];
    /// self + factor · other.
    fn add_scaled(self, factor: Self::Real, other: Self) -> Self;

    /// self + other.
    #[inline]
    fn plus(self, other: Self) -> Self {
        self.add_scaled(Self::Real::from_f64(1.0), other)
    }
    /// self − other.
    #[inline]
    fn minus(self, other: Self) -> Self {
        self.add_scaled(Self::Real::from_f64(-1.0), other)
    }
    /// factor · self.
    #[inline]
    fn scaled(self, factor: Self::Real) -> Self {
        Self::default().add_scaled(factor, self)
    }
}

/// A matrix entry that multiplies what vectors of `V` hold.
pub trait Acts<V: Nodal>: Copy + Debug + Default + PartialEq + Send + Sync + 'static {
    /// sum + self · x.
    fn add_product(self, x: V, sum: V) -> V;
}

/// An entry of a square matrix: a number, or a 3 × 3 block, row by row.
pub trait Entry: Acts<Self::Nodal> {
    /// Its precision.
    type Real: Real;
    /// What it multiplies.
    type Nodal: Nodal<Real = Self::Real>;
    /// The same in single precision.
    type Single: Entry<Real = f32>;
    /// How many rows and columns it has.
    const SIZE: usize;

    /// From its numbers by row and column, each rounded.
    fn from_fn(number: impl FnMut(usize, usize) -> f64) -> Self;
    /// The number in a row and column.
    fn at(&self, row: usize, column: usize) -> Self::Real;
    /// All numbers of an array of entries.
    fn flat(values: &[Self]) -> &[Self::Real];
    /// With rows and columns exchanged.
    fn transposed(self) -> Self;
    /// self + factor · other.
    fn add_scaled(self, factor: Self::Real, other: Self) -> Self;
    /// The matrix product.
    fn times(self, other: Self) -> Self;

    /// factor · self.
    #[inline]
    fn scaled(self, factor: Self::Real) -> Self {
        Self::default().add_scaled(factor, self)
    }
    /// The unit matrix.
    fn identity() -> Self {
        Self::from_fn(|i, j| if i == j { 1.0 } else { 0.0 })
    }
    /// `scale` times the same entry in another precision.
    ///
    /// # Panics
    /// If `F` has another size.
    #[inline]
    fn cast_scaled<F: Entry>(self, scale: f64) -> F {
        const { assert!(F::SIZE == Self::SIZE) };
        F::from_fn(|i, j| scale * self.at(i, j).to_f64())
    }
    /// The sum of absolute values in each row, the largest of them.
    fn norm(&self) -> f64 {
        let row = |i| (0..Self::SIZE).map(|j| self.at(i, j).to_f64().abs()).sum::<f64>();
        (0..Self::SIZE).map(row).fold(0.0, f64::max)
    }
    /// The inverse of a symmetric positive definite entry, computed in double
    /// precision.
    ///
    /// # Errors
    /// The first pivot of its Cholesky factorisation that is not positive.
    fn inverse(&self) -> Result<Self, f64> {
        let n = Self::SIZE;
        let inverse = inverse_spd(n, |i, j| self.at(i, j).to_f64())?;
        Ok(Self::from_fn(|i, j| inverse[i][j]))
    }
}

/// Gauss–Jordan elimination without pivoting, which symmetric positive definite
/// matrices allow: the pivots are then the squares of Cholesky's. The result is
/// symmetric to the last bit.
fn inverse_spd(n: usize, at: impl Fn(usize, usize) -> f64) -> Result<[[f64; 3]; 3], f64> {
    let mut a = [[0.0; 3]; 3];
    let mut inverse = [[0.0; 3]; 3];
    for i in 0..n {
        (0..n).for_each(|j| a[i][j] = at(i, j));
        inverse[i][i] = 1.0;
    }
    for k in 0..n {
        let pivot = a[k][k];
        // A pivot that is rounding alone says as little as a negative one.
        if pivot.is_nan() || pivot <= 8.0 * f64::EPSILON * at(k, k).abs() {
            return Err(pivot);
        }
        for j in 0..n {
            a[k][j] /= pivot;
            inverse[k][j] /= pivot;
        }
        for i in (0..n).filter(|i| *i != k) {
            let factor = a[i][k];
            for j in 0..n {
                a[i][j] -= factor * a[k][j];
                inverse[i][j] -= factor * inverse[k][j];
            }
        }
    }
    for i in 0..n {
        for j in 0..i {
            let mean = 0.5 * (inverse[i][j] + inverse[j][i]);
            (inverse[i][j], inverse[j][i]) = (mean, mean);
        }
    }
    Ok(inverse)
}

impl<T: Real> Nodal for T {
    type Real = T;
    const SIZE: usize = 1;

    fn from_fn(mut number: impl FnMut(usize) -> f64) -> Self {
        T::from_f64(number(0))
    }
    #[inline]
    fn at(&self, _: usize) -> T {
        *self
    }
    fn flat(values: &[Self]) -> &[T] {
        values
    }
    fn flat_mut(values: &mut [Self]) -> &mut [T] {
        values
    }
    #[inline]
    fn add_scaled(self, factor: T, other: Self) -> Self {
        self + factor * other
    }
}

impl<T: Real> Nodal for [T; 3] {
    type Real = T;
    const SIZE: usize = 3;

    fn from_fn(mut number: impl FnMut(usize) -> f64) -> Self {
        std::array::from_fn(|k| T::from_f64(number(k)))
    }
    #[inline]
    fn at(&self, k: usize) -> T {
        self[k]
    }
    fn flat(values: &[Self]) -> &[T] {
        values.as_flattened()
    }
    fn flat_mut(values: &mut [Self]) -> &mut [T] {
        values.as_flattened_mut()
    }
    #[inline]
    fn add_scaled(self, factor: T, other: Self) -> Self {
        std::array::from_fn(|k| self[k] + factor * other[k])
    }
}

impl<T: Real, V: Nodal<Real = T>> Acts<V> for T {
    #[inline]
    fn add_product(self, x: V, sum: V) -> V {
        sum.add_scaled(self, x)
    }
}

impl<T: Real> Acts<[T; 3]> for [[T; 3]; 3] {
    #[inline]
    fn add_product(self, x: [T; 3], sum: [T; 3]) -> [T; 3] {
        std::array::from_fn(|i| {
            let [a, b, c] = self[i];
            sum[i] + (a * x[0] + b * x[1] + c * x[2])
        })
    }
}

impl<T: Real> Entry for T {
    type Real = T;
    type Nodal = T;
    type Single = f32;
    const SIZE: usize = 1;

    #[inline]
    fn from_fn(mut number: impl FnMut(usize, usize) -> f64) -> Self {
        T::from_f64(number(0, 0))
    }
    #[inline]
    fn at(&self, _: usize, _: usize) -> T {
        *self
    }
    fn flat(values: &[Self]) -> &[T] {
        values
    }
    #[inline]
    fn transposed(self) -> Self {
        self
    }
    #[inline]
    fn add_scaled(self, factor: T, other: Self) -> Self {
        self + factor * other
    }
    #[inline]
    fn times(self, other: Self) -> Self {
        self * other
    }
}

impl<T: Real> Entry for [[T; 3]; 3] {
    type Real = T;
    type Nodal = [T; 3];
    type Single = [[f32; 3]; 3];
    const SIZE: usize = 3;

    #[inline]
    fn from_fn(mut number: impl FnMut(usize, usize) -> f64) -> Self {
        std::array::from_fn(|i| std::array::from_fn(|j| T::from_f64(number(i, j))))
    }
    #[inline]
    fn at(&self, row: usize, column: usize) -> T {
        self[row][column]
    }
    fn flat(values: &[Self]) -> &[T] {
        values.as_flattened().as_flattened()
    }
    #[inline]
    fn transposed(self) -> Self {
        std::array::from_fn(|i| std::array::from_fn(|j| self[j][i]))
    }
    #[inline]
    fn add_scaled(self, factor: T, other: Self) -> Self {
        std::array::from_fn(|i| self[i].add_scaled(factor, other[i]))
    }
    #[inline]
    fn times(self, other: Self) -> Self {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                self[i][0] * other[0][j] + self[i][1] * other[1][j] + self[i][2] * other[2][j]
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCK: [[f64; 3]; 3] = [[4.0, 2.0, 0.0], [2.0, 5.0, 1.0], [0.0, 1.0, 3.0]];

    #[test]
    fn blocks_multiply_by_rows() {
        let a = [[1.0, 2.0, 3.0], [0.0, 1.0, 0.0], [4.0, 0.0, 0.0]];
        assert_eq!(a.add_product([1.0, 10.0, 100.0], [0.5, 0.0, 0.0]), [321.5, 10.0, 4.0]);
        assert_eq!(a.transposed()[2], [3.0, 0.0, 0.0]);
        assert_eq!(a.times(Entry::identity()), a);
        // The second row of A Aᵀ.
        assert_eq!(a.times(a.transposed())[1], [2.0, 1.0, 0.0]);
        assert_eq!(2.0.add_product([1.0, 2.0, 3.0], [1.0; 3]), [3.0, 5.0, 7.0]);
        assert_eq!((a.norm(), (-3.0f32).norm()), (6.0, 3.0));
        let single: [[f32; 3]; 3] = a.cast_scaled(0.5);
        assert_eq!(single[0], [0.5, 1.0, 1.5]);
    }

    #[test]
    fn the_inverse_of_a_known_block() {
        // det = 4 (15 − 1) − 2 (6 − 0) = 44; the cofactors by hand.
        let cofactors = [[14.0, -6.0, 2.0], [-6.0, 12.0, -4.0], [2.0, -4.0, 16.0]];
        let inverse = BLOCK.inverse().unwrap();
        for i in 0..3 {
            for j in 0..3 {
                assert!((inverse[i][j] - cofactors[i][j] / 44.0).abs() < 1e-15);
            }
        }
        assert_eq!(4.0.inverse(), Ok(0.25));
        assert_eq!((-4.0).inverse(), Err(-4.0));
        let mut indefinite = BLOCK;
        indefinite[1][1] = 0.5; // second pivot 0.5 − 2²/4
        assert_eq!(indefinite.inverse(), Err(-0.5));
        assert!([[f64::NAN; 3]; 3].inverse().is_err());
    }
}
