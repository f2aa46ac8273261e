//! An elastic body from the names that a config uses.

use octruss_base::choice::named;
use octruss_fem::{ByRegion, Elasticity, Free, Held, Material, Stiffness, Support, vector};
use octruss_mesh::RawMesh;
use serde::Deserialize;
use toml::Spanned;

use super::fixed::Fixed;
use crate::error::Error;
use crate::options::{
    MaterialKeys, OnSurface, PerRegion, Springs, Value, ValueOrVector, VectorOnSurface, VectorValue,
};
use crate::stages::context::Context;
use crate::stages::groups::{by_region, on_surfaces};

/// The data of an elastic body.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct ElasticityKeys {
    /// What is prescribed on surfaces; on a common edge the last listed counts.
    pub fixed: Vec<Spanned<Fixed>>,
    /// One material, or one a region.
    pub material: Option<PerRegion<MaterialKeys>>,
    /// Force per unit of volume, one vector or one a region.
    pub body_force: PerRegion<VectorValue>,
    /// Acceleration; times density a force per unit of volume.
    pub gravity: VectorValue,
    /// Force per unit of area on surfaces.
    pub traction: Vec<VectorOnSurface>,
    /// Force per unit of area against the outward normal: positive pushes inward.
    pub pressure: Vec<OnSurface>,
    /// Force per unit of area and of displacement, against it.
    pub springs: Vec<Springs>,
    /// What becomes of parts that can move without deforming.
    #[serde(deserialize_with = "named")]
    pub free: Free,
}

impl Default for ElasticityKeys {
    fn default() -> Self {
        Self {
            fixed: Vec::new(),
            material: None,
            body_force: PerRegion::Uniform(VectorValue::ZERO),
            gravity: VectorValue::ZERO,
            traction: Vec::new(),
            pressure: Vec::new(),
            springs: Vec::new(),
            free: Free::default(),
        }
    }
}

/// The problem that a stage describes, on this mesh.
pub(crate) fn problem(
    keys: &ElasticityKeys,
    mesh: &RawMesh,
    context: &Context,
) -> Result<Elasticity, Error> {
    let zero = vector([0.0; 3]);
    let loads = keys.traction.iter().map(|at| (&at.surface, at.value.to_vector()));
    let pressures = keys.pressure.iter().map(|at| (&at.surface, at.value.to_scalar()));
    let springs = keys.springs.iter().map(|at| (&at.surface, stiffness(&at.stiffness)));
    let fixed = keys.fixed.iter().map(|entry| entry.get_ref());
    let supports = on_surfaces(fixed.map(|at| (&at.surface, held(at))), mesh, context)?;
    Ok(Elasticity {
        material: materials(keys, mesh, context)?,
        body_force: by_region(&keys.body_force, VectorValue::to_vector, zero, mesh, context)?,
        gravity: keys.gravity.to_vector(),
        traction: on_surfaces(loads, mesh, context)?,
        pressure: on_surfaces(pressures, mesh, context)?,
        springs: on_surfaces(springs, mesh, context)?,
        supports: supports.into_iter().map(|(surface, held)| Support { surface, held }).collect(),
        free: keys.free,
    })
}

/// The material of each region; every region in use must have one.
fn materials(
    keys: &ElasticityKeys,
    mesh: &RawMesh,
    context: &Context,
) -> Result<ByRegion<Material>, Error> {
    let given = keys
        .material
        .as_ref()
        .ok_or_else(|| context.request("problem = \"elasticity\" needs `material`".into()))?;
    let convert = |material: &MaterialKeys| Material {
        young: material.young.to_scalar(),
        poisson: material.poisson.to_scalar(),
        density: material.density.to_scalar(),
    };
    // Stands where nothing is given, which is refused below.
    let none = Material::new(f64::NAN, f64::NAN);
    let materials = by_region(given, convert, none, mesh, context)?;
    let has_default = match given {
        PerRegion::Uniform(_) => true,
        PerRegion::Named(named) => {
            named.iter().any(|(name, _)| name.get_ref() == PerRegion::<MaterialKeys>::DEFAULT)
        }
    };
    let named = |id: &i32| materials.regions.iter().any(|(region, _)| region == id);
    match mesh.ids(3).into_iter().find(|id| !has_default && !named(id)) {
        None => Ok(materials),
        Some(id) => {
            let name = mesh.group_name(3, id);
            Err(context.request(format!(
                "region `{name}` has no material: give it one in `material`, or one for all \
                 others as `default`"
            )))
        }
    }
}

/// What an entry of `fixed` holds; that it says so in one way is checked when
/// the config is read.
fn held(fixed: &Fixed) -> Held {
    let Fixed { value, x, y, z, normal, .. } = fixed;
    match (value, normal) {
        (Some(ValueOrVector::Other(value)), _) => Held::Components(value.to_vector().map(Some)),
        (_, Some(normal)) => Held::Normal(normal.to_scalar()),
        _ => Held::Components([x, y, z].map(|value| value.as_ref().map(Value::to_scalar))),
    }
}

fn stiffness(given: &ValueOrVector) -> Stiffness {
    match given {
        ValueOrVector::One(value) => Stiffness::Normal(value.to_scalar()),
        ValueOrVector::Other(vector) => Stiffness::Axes(vector.to_vector()),
    }
}
