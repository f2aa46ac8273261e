//! What a config prescribes on a surface.

use serde::Deserialize;
use toml::Spanned;

use super::solve::Problem;
use crate::recipe::{Value, ValueOrVector};

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
    pub(super) fn contradiction(&self, problem: Problem) -> Option<String> {
        let by_component = [&self.x, &self.y, &self.z].into_iter().any(Option::is_some);
        let ways = [self.value.is_some(), by_component, self.normal.is_some()];
        match problem {
            Problem::Poisson | Problem::Biharmonic => {
                let good = matches!(self.value, Some(ValueOrVector::One(_)));
                (!good || ways != [true, false, false]).then(|| {
                    "an entry of `fixed` gives one `value`: x, y, z, normal and lists of three \
                     belong to problem = \"elasticity\""
                        .into()
                })
            }
            Problem::Elasticity if ways.into_iter().filter(|way| *way).count() != 1 => Some(
                "an entry of `fixed` gives the displacement in one of three ways: \
                 value = [0, 0, 0], some of x, y and z, or normal = 0"
                    .into(),
            ),
            Problem::Elasticity => matches!(self.value, Some(ValueOrVector::One(_))).then(|| {
                "`value` of a displacement is a list of three; for one component give x, y, z or \
                 normal"
                    .into()
            }),
        }
    }
}
