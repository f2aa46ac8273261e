//! What a config prescribes on a surface.

use octruss_fem::Scalar;
use octruss_mesh::RawMesh;
use serde::Deserialize;
use toml::Spanned;

use super::equation::Equation;
use crate::error::Error;
use crate::options::{Value, ValueOrVector};
use crate::stages::context::Context;
use crate::stages::groups::on_surfaces;

/// What is prescribed on a named surface: of scalar problems `value`; of
/// elasticity the displacement, as `value` wholly, as `x`, `y` and `z` by
/// components, or as `normal`, the outward component alone.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Fixed {
    /// The surface group.
    pub surface: Spanned<String>,
    /// u; of elasticity three components.
    pub value: Option<ValueOrVector>,
    /// The displacement along x.
    pub x: Option<Value>,
    /// The displacement along y.
    pub y: Option<Value>,
    /// The displacement along z.
    pub z: Option<Value>,
    /// The displacement along the outward normal: 0 for a plane of symmetry, or
    /// to slide along the surface.
    pub normal: Option<Value>,
}

impl Fixed {
    /// What is wrong with the entry in this problem, if anything.
    pub(super) fn contradiction(&self, equation: Equation) -> Option<String> {
        let by_component = [&self.x, &self.y, &self.z].into_iter().any(Option::is_some);
        let ways = [self.value.is_some(), by_component, self.normal.is_some()];
        match equation {
            Equation::Poisson | Equation::Biharmonic => {
                let good = matches!(self.value, Some(ValueOrVector::One(_)));
                (!good || ways != [true, false, false]).then(|| {
                    "an entry of `fixed` gives one `value`: x, y, z, normal and lists of three \
                     belong to problem = \"elasticity\""
                        .into()
                })
            }
            Equation::Elasticity if ways.into_iter().filter(|way| *way).count() != 1 => Some(
                "an entry of `fixed` gives the displacement in one of three ways: \
                 value = [0, 0, 0], some of x, y and z, or normal = 0"
                    .into(),
            ),
            Equation::Elasticity => matches!(self.value, Some(ValueOrVector::One(_))).then(|| {
                "`value` of a displacement is a list of three; for one component give x, y, z or \
                 normal"
                    .into()
            }),
        }
    }
}

/// The prescribed values of surfaces, of a scalar problem. That every entry gives one is
/// checked when the config is read.
///
/// # Errors
/// A surface that the mesh does not have.
pub(super) fn fixed_values(
    fixed: &[Spanned<Fixed>],
    mesh: &RawMesh,
    context: &Context,
) -> Result<Vec<(i32, Scalar)>, Error> {
    let value = |given: &Option<ValueOrVector>| match given {
        Some(ValueOrVector::One(value)) => value.to_scalar(),
        _ => Scalar::from(0.0),
    };
    let fixed = fixed.iter().map(Spanned::get_ref);
    on_surfaces(fixed.map(|at| (&at.surface, value(&at.value))), mesh, context)
}
