//! The biharmonic equation.

use crate::problem::by_region::ByRegion;
use crate::problem::scalar::Scalar;

/// Δ²u = f with u prescribed on surfaces.
#[derive(Debug, Clone)]
pub struct Biharmonic {
    /// f, per unit of volume.
    pub source: ByRegion,
    /// u on surfaces, which are clamped: ∂u/∂n = 0. A vertex on two of them takes the
    /// value of the last listed.
    pub fixed: Vec<(i32, Scalar)>,
}
