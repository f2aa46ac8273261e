//! Stresses and forces of an elastic body.

use serde::{Deserialize, Serialize};

use crate::null::null_as_nan;

/// Stresses and forces of an elastic body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BodyFigures {
    /// The greatest of von Mises' stress in a tet.
    #[serde(deserialize_with = "null_as_nan")]
    pub greatest_von_mises: f64,
    /// What acts on the body.
    pub forces: ForceFigures,
}

/// The forces on a body, each summed over a surface or all of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ForceFigures {
    /// With which each fixed surface holds the body.
    pub reactions: Vec<SurfaceForce>,
    /// With which springs on each surface do; left out without springs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub springs: Vec<SurfaceForce>,
    /// Body forces, gravity, tractions and pressures.
    pub loads: Force,
    /// The inertia that balances the loads of parts that nothing holds; left out without any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<Force>,
    /// The size of the sum of all of them, relative to what acts: the sizes of the forces at
    /// vertices, summed for loads, reactions and springs apart, the largest.
    #[serde(deserialize_with = "null_as_nan")]
    pub imbalance: f64,
}

/// A force on a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Force {
    /// Its component along x.
    #[serde(deserialize_with = "null_as_nan")]
    pub x: f64,
    /// Its component along y.
    #[serde(deserialize_with = "null_as_nan")]
    pub y: f64,
    /// Its component along z.
    #[serde(deserialize_with = "null_as_nan")]
    pub z: f64,
}

/// A force on a body from a named surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SurfaceForce {
    /// The surface, as the config calls it.
    pub name: String,
    /// The force there.
    #[serde(flatten)]
    pub force: Force,
}

impl From<[f64; 3]> for Force {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self { x, y, z }
    }
}
