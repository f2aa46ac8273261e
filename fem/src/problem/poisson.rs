//! What is to be solved: −div(k grad u) = f with boundary data by surface.

use crate::problem::by_region::ByRegion;
use crate::problem::free::Free;
use crate::problem::scalar::Scalar;

/// −div(k grad u) = f in the body, u or k ∂u/∂n given on its surfaces.
///
/// Surfaces are named by the tags of the mesh's triangles. Where nothing is
/// prescribed, the natural condition k ∂u/∂n = 0 holds.
#[derive(Debug, Clone)]
pub struct Poisson {
    /// k > 0, taken at the centroid of each tet.
    pub coefficient: ByRegion,
    /// f, per unit of volume.
    pub source: ByRegion,
    /// u on surfaces. A vertex on two of them takes the value of the last listed.
    pub fixed: Vec<(i32, Scalar)>,
    /// k ∂u/∂n on surfaces (n outward): what flows in per unit of area. A
    /// surface listed twice gets the sum; where u is fixed, flux has no effect.
    pub flux: Vec<(i32, Scalar)>,
    /// k ∂u/∂n = c (u₀ − u) on surfaces; several on one surface add up, also with
    /// flux.
    pub robin: Vec<(i32, Robin)>,
    /// What becomes of parts with neither a fixed value nor a Robin condition.
    pub free: Free,
}

/// Exchange with a surrounding: k ∂u/∂n = c (u₀ − u), such as the cooling of a
/// surface by air.
#[derive(Debug, Clone)]
pub struct Robin {
    /// c ≥ 0, per unit of area.
    pub coefficient: Scalar,
    /// u₀, the value that the surface would take in the end.
    pub value: Scalar,
}

impl Default for Poisson {
    /// k = 1, f = 0, no boundary data; free parts are refused.
    fn default() -> Self {
        Self {
            coefficient: 1.0.into(),
            source: 0.0.into(),
            fixed: Vec::new(),
            flux: Vec::new(),
            robin: Vec::new(),
            free: Free::Refuse,
        }
    }
}
