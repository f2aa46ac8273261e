//! What became of the fields on the way to the finest mesh.

use std::collections::BTreeMap;

use octruss_base::chunks::map_ranges;
use octruss_meshio::Field;
use serde::{Deserialize, Serialize};

use crate::state::{State, floats};

/// The fields on the finest mesh, by name.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct CarriedFields {
    /// Moved by the same matrix as the vertices.
    pub vertices: BTreeMap<String, FieldFigures>,
    /// The same, for each region that touches a vertex by itself.
    pub sides: BTreeMap<String, FieldFigures>,
    /// Inherited from tet to tet.
    pub tets: BTreeMap<String, FieldFigures>,
    /// How many values were brought back into the range of their stencils, on
    /// all levels of the stage together; only where that was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clamped: Option<usize>,
}

/// One field.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FieldFigures {
    /// Values a vertex, side or tet.
    pub components: usize,
    /// The least finite value of any component; null if there is none.
    pub minimum: Option<f64>,
    /// The greatest.
    pub maximum: Option<f64>,
    /// How many values are no numbers.
    pub not_numbers: usize,
    /// The greatest difference between two sides of a vertex, of fields that
    /// may jump.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub largest_jump: Option<f64>,
}

impl CarriedFields {
    pub(crate) fn of(state: &State, clamped: Option<usize>) -> Self {
        let figures = |fields: &[Field]| -> BTreeMap<String, FieldFigures> {
            fields.iter().map(|field| (field.name.clone(), FieldFigures::of(field))).collect()
        };
        let mut sides = figures(&state.sided_fields.fields);
        if let Some(pairs) = &state.sided_fields.sides {
            for field in &state.sided_fields.fields {
                let jump = pairs.largest_jump(&floats(field), field.components);
                let figures = sides.get_mut(&field.name);
                figures.into_iter().for_each(|figures| figures.largest_jump = Some(jump));
            }
        }
        Self {
            vertices: figures(&state.point_fields),
            sides,
            tets: figures(&state.cell_fields),
            clamped,
        }
    }
}

impl FieldFigures {
    fn of(field: &Field) -> Self {
        let values = floats(field);
        let parts = map_ranges(values.len(), |range| {
            let values = &values[range];
            let numbers = values.iter().copied().filter(|value| value.is_finite());
            let not_numbers = values.iter().filter(|value| value.is_nan()).count();
            (numbers.clone().reduce(f64::min), numbers.reduce(f64::max), not_numbers)
        });
        Self {
            components: field.components,
            minimum: parts.iter().filter_map(|part| part.0).reduce(f64::min),
            maximum: parts.iter().filter_map(|part| part.1).reduce(f64::max),
            not_numbers: parts.iter().map(|part| part.2).sum(),
            largest_jump: None,
        }
    }
}
