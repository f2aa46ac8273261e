//! Remarks on fields that are to be refined.

use octruss_meshio::Values;

use crate::state::{State, floats};

/// Remarks on fields at vertices that refining changes in ways that may surprise.
pub(super) fn field_notes(state: &State, levels: u8) -> Vec<String> {
    let mut notes = Vec::new();
    for field in state.point_fields.iter().filter(|_| levels > 0) {
        let name = &field.name;
        if matches!(field.values, Values::Integer(_)) {
            notes.push(format!(
                "the field `{name}` holds whole numbers; refined, it holds means of them"
            ));
        }
        let values = floats(field);
        let tuples = values.chunks(field.components.max(1));
        let missing = tuples.filter(|tuple| tuple.iter().any(|value| value.is_nan())).count();
        if missing > 0 {
            notes.push(format!(
                "the field `{name}` is no number at {missing} of {} vertices, and none at new \
                 vertices that read these",
                field.tuples()
            ));
        }
    }
    notes
}
