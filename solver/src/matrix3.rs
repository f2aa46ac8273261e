//! Vectors and 3 × 3 matrices as plain arrays.

pub(crate) type Vector3 = [f64; 3];
pub(crate) type Matrix3 = [[f64; 3]; 3];

pub(crate) const ZERO: Matrix3 = [[0.0; 3]; 3];
pub(crate) const IDENTITY: Matrix3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

#[inline]
pub(crate) fn add(a: Vector3, b: Vector3) -> Vector3 {
    std::array::from_fn(|k| a[k] + b[k])
}

#[inline]
pub(crate) fn subtract(a: Vector3, b: Vector3) -> Vector3 {
    std::array::from_fn(|k| a[k] - b[k])
}

#[inline]
pub(crate) fn scale(factor: f64, a: Vector3) -> Vector3 {
    a.map(|x| factor * x)
}

#[inline]
pub(crate) fn cross(a: Vector3, b: Vector3) -> Vector3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
pub(crate) fn dot3(a: Vector3, b: Vector3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(crate) fn length(a: Vector3) -> f64 {
    dot3(a, a).sqrt()
}

/// A x.
#[inline]
pub(crate) fn apply(a: &Matrix3, x: Vector3) -> Vector3 {
    a.map(|row| dot3(row, x))
}

/// A B.
#[inline]
pub(crate) fn multiply3(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
    })
}

#[inline]
pub(crate) fn transpose3(a: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

#[inline]
pub(crate) fn add3(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| add(a[i], b[i]))
}

/// a bᵀ.
#[inline]
pub(crate) fn outer(a: Vector3, b: Vector3) -> Matrix3 {
    a.map(|x| scale(x, b))
}
