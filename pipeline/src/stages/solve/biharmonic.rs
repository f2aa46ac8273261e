//! A biharmonic problem from the names that a config uses.

use octruss_fem::{Biharmonic, Scalar};
use octruss_mesh::RawMesh;
use serde::Deserialize;
use toml::Spanned;

use super::fixed::{Fixed, fixed_values};
use crate::error::Error;
use crate::options::{PerRegion, Value};
use crate::stages::context::Context;
use crate::stages::groups::by_region;

/// The data of Δ²u = f.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct BiharmonicKeys {
    /// What is prescribed on surfaces; on a common edge the last listed counts.
    pub fixed: Vec<Spanned<Fixed>>,
    /// f per unit of volume, one value or one a region; 0 where none is given.
    pub source: PerRegion,
}

impl Default for BiharmonicKeys {
    fn default() -> Self {
        Self { fixed: Vec::new(), source: PerRegion::Uniform(Value::Number(0.0)) }
    }
}

/// The problem that a stage describes, on this mesh.
///
/// # Errors
/// A surface or region that the mesh does not have.
pub(crate) fn problem(
    keys: &BiharmonicKeys,
    mesh: &RawMesh,
    context: &Context,
) -> Result<Biharmonic, Error> {
    let zero = Scalar::from(0.0);
    Ok(Biharmonic {
        source: by_region(&keys.source, Value::to_scalar, zero, mesh, context)?,
        fixed: fixed_values(&keys.fixed, mesh, context)?,
    })
}
