//! A Poisson problem from the names that a config uses.

use octruss_base::choice::named;
use octruss_fem::{Free, Poisson, Robin, Scalar};
use octruss_mesh::RawMesh;
use serde::Deserialize;
use toml::Spanned;

use super::fixed::{Fixed, fixed_values};
use crate::error::Error;
use crate::options::{OnSurface, PerRegion, RobinOnSurface, Value};
use crate::stages::context::Context;
use crate::stages::groups::{by_region, on_surfaces};

/// The data of −div(k grad u) = f.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct PoissonKeys {
    /// What is prescribed on surfaces; on a common edge the last listed counts.
    pub fixed: Vec<Spanned<Fixed>>,
    /// k > 0, one value or one a region; 1 where none is given.
    pub coefficient: PerRegion,
    /// f per unit of volume, one value or one a region; 0 where none is given.
    pub source: PerRegion,
    /// k ∂u/∂n on surfaces, n outward: what flows in per unit of area.
    pub flux: Vec<OnSurface>,
    /// k ∂u/∂n = coefficient (value − u) on surfaces.
    pub robin: Vec<RobinOnSurface>,
    /// What becomes of parts with neither a fixed surface nor a Robin condition.
    #[serde(deserialize_with = "named")]
    pub free: Free,
}

impl Default for PoissonKeys {
    fn default() -> Self {
        Self {
            fixed: Vec::new(),
            coefficient: PerRegion::Uniform(Value::Number(1.0)),
            source: PerRegion::Uniform(Value::Number(0.0)),
            flux: Vec::new(),
            robin: Vec::new(),
            free: Free::default(),
        }
    }
}

/// The problem that a stage describes, on this mesh.
///
/// # Errors
/// A surface or region that the mesh does not have.
pub(crate) fn problem(
    keys: &PoissonKeys,
    mesh: &RawMesh,
    context: &Context,
) -> Result<Poisson, Error> {
    let scalars = |given, otherwise: f64| {
        by_region(given, Value::to_scalar, Scalar::from(otherwise), mesh, context)
    };
    Ok(Poisson {
        coefficient: scalars(&keys.coefficient, 1.0)?,
        source: scalars(&keys.source, 0.0)?,
        fixed: fixed_values(&keys.fixed, mesh, context)?,
        flux: on_surfaces(
            keys.flux.iter().map(|at| (&at.surface, at.value.to_scalar())),
            mesh,
            context,
        )?,
        robin: on_surfaces(
            keys.robin.iter().map(|at| {
                let coefficient = at.coefficient.to_scalar();
                (&at.surface, Robin { coefficient, value: at.value.to_scalar() })
            }),
            mesh,
            context,
        )?,
        free: keys.free,
    })
}
