//! What is to be solved: −div(k grad u) = f with boundary data by surface.

use crate::error::Error;
use octruss_mesh::TetMesh;
use std::fmt;
use std::sync::Arc;

/// A number, or a number for each position.
#[derive(Clone)]
pub enum Scalar {
    /// The same everywhere.
    Constant(f64),
    /// A function of the position in mesh units.
    Function(Arc<dyn Fn([f64; 3]) -> f64 + Send + Sync>),
}

impl Scalar {
    /// A function of the position.
    ///
    /// ```
    /// let height = octruss_solver::Scalar::function(|[_, _, z]| 2.0 * z);
    /// assert_eq!(height.at([0.0, 0.0, 1.5]), 3.0);
    /// ```
    pub fn function(f: impl Fn([f64; 3]) -> f64 + Send + Sync + 'static) -> Self {
        Self::Function(Arc::new(f))
    }

    /// The value at one position.
    #[inline]
    pub fn at(&self, position: [f64; 3]) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Function(f) => f(position),
        }
    }
}

impl From<f64> for Scalar {
    fn from(value: f64) -> Self {
        Self::Constant(value)
    }
}

impl fmt::Debug for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant(value) => write!(f, "{value}"),
            Self::Function(_) => write!(f, "function"),
        }
    }
}

/// A value for each region, by region id.
#[derive(Debug, Clone)]
pub struct ByRegion {
    /// Holds in regions that are not listed.
    pub default: Scalar,
    /// Regions with a value of their own; the last entry for an id counts.
    pub regions: Vec<(i32, Scalar)>,
}

impl ByRegion {
    /// The value in one region.
    #[inline]
    pub fn of(&self, region: i32) -> &Scalar {
        let listed = self.regions.iter().rev().find(|(id, _)| *id == region);
        listed.map_or(&self.default, |(_, value)| value)
    }

    /// Checks that every listed region has tets.
    pub(crate) fn check(&self, mesh: &TetMesh) -> Result<(), Error> {
        for &(id, _) in &self.regions {
            if !mesh.regions().contains(&id) {
                return Err(Error::UnknownRegion { id, known: mesh.raw().ids(3) });
            }
        }
        Ok(())
    }
}

impl From<f64> for ByRegion {
    fn from(value: f64) -> Self {
        Self { default: value.into(), regions: Vec::new() }
    }
}

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
}

impl Default for Poisson {
    /// k = 1, f = 0, no boundary data.
    fn default() -> Self {
        Self { coefficient: 1.0.into(), source: 0.0.into(), fixed: Vec::new(), flux: Vec::new() }
    }
}

/// Checks that a surface id is in use.
pub(crate) fn check_surface(mesh: &TetMesh, id: i32) -> Result<(), Error> {
    if mesh.triangles().tags.contains(&id) {
        Ok(())
    } else {
        Err(Error::UnknownSurface { id, known: mesh.triangles().ids() })
    }
}
