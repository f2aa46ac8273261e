//! The two floating-point types a matrix may hold.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Mul, Sub};

/// `f32` or `f64`: double precision for the problem, single (half the bytes)
/// for the preconditioner.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialEq
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + AddAssign
    + Into<f64>
    + 'static
{
    /// Rounds to this type.
    fn from_f64(value: f64) -> Self;
    /// The same value in double precision, exactly.
    fn to_f64(self) -> f64;
}

impl Real for f64 {
    fn from_f64(value: f64) -> Self {
        value
    }
    fn to_f64(self) -> f64 {
        self
    }
}

impl Real for f32 {
    fn from_f64(value: f64) -> Self {
        value as f32
    }
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
}
