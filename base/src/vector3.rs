//! Vectors and 3 × 3 matrices as plain arrays.

/// A vector.
pub type Vector3 = [f64; 3];
/// A matrix, row by row.
pub type Matrix3 = [[f64; 3]; 3];

/// All zeros.
pub const ZERO: Matrix3 = [[0.0; 3]; 3];
/// Ones on the diagonal.
pub const IDENTITY: Matrix3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// a + b.
#[inline]
pub fn add(a: Vector3, b: Vector3) -> Vector3 {
    std::array::from_fn(|k| a[k] + b[k])
}

/// a − b.
#[inline]
pub fn subtract(a: Vector3, b: Vector3) -> Vector3 {
    std::array::from_fn(|k| a[k] - b[k])
}

/// `factor` times a.
#[inline]
pub fn scale(factor: f64, a: Vector3) -> Vector3 {
    a.map(|x| factor * x)
}

/// a × b.
#[inline]
pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a · b.
#[inline]
pub fn dot3(a: Vector3, b: Vector3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// ‖a‖.
#[inline]
pub fn length(a: Vector3) -> f64 {
    dot3(a, a).sqrt()
}

/// A x.
#[inline]
pub fn apply(a: &Matrix3, x: Vector3) -> Vector3 {
    a.map(|row| dot3(row, x))
}

/// A B.
#[inline]
pub fn multiply3(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
    })
}

/// Aᵀ.
#[inline]
pub fn transpose3(a: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// A + B.
#[inline]
pub fn add3(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| add(a[i], b[i]))
}

/// a bᵀ.
#[inline]
pub fn outer(a: Vector3, b: Vector3) -> Matrix3 {
    a.map(|x| scale(x, b))
}
