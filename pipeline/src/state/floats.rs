//! Values of fields as numbers to compute with.

use std::borrow::Cow;

use octruss_meshio::{Field, Values};

/// The values of a field as floating-point numbers: means of whole numbers are
/// not whole.
pub(crate) fn floats(field: &Field) -> Cow<'_, [f64]> {
    match &field.values {
        Values::Float(values) => values.into(),
        Values::Integer(values) => values.iter().map(|&value| value as f64).collect(),
    }
}
