//! Fields that are to jump between regions.

use octruss_base::suggestion::suggestion;
use octruss_mesh::Sides;
use octruss_meshio::{Field, Values};
use toml::Spanned;

use super::context::Context;
use crate::error::Error;
use crate::state::{SidedFields, State, floats};

/// Where the values of a side come from.
#[derive(Clone, Copy)]
enum Source<'a> {
    /// It has sides already.
    Sides,
    Vertices(&'a Field),
    Tets(&'a Field),
}

/// Starts a field of sides for each name of a field on vertices or tets; those
/// that there are already, from an earlier stage or from values at corners of
/// tets, go on in any case. Returns remarks.
///
/// # Errors
/// A name that no field has, or two have, with its place in the config.
pub(super) fn start_jumps(
    names: &[Spanned<String>],
    state: &mut State,
    context: &Context,
) -> Result<Vec<String>, Error> {
    let mesh = context.needed(state.mesh.finest())?;
    let mut notes = Vec::new();
    let mut started = Vec::new();
    let sides = state.sided_fields.sides.clone();
    let sides = sides.unwrap_or_else(|| Sides::new(mesh));
    for name in names {
        let text = name.get_ref();
        if started.iter().any(|field: &Field| field.name == *text) {
            continue;
        }
        let (field, values) = match source(name, state, context)? {
            Source::Sides => continue,
            Source::Tets(field) => (field, sides.from_tets(mesh, &floats(field), field.components)),
            Source::Vertices(field) => {
                notes.push(format!(
                    "the field `{text}` has one value a vertex: its sides start equal, and stay so"
                ));
                (field, sides.from_vertices(&floats(field), field.components))
            }
        };
        started.push(Field::new(text, field.components, Values::Float(values)));
    }
    let SidedFields { sides: kept, fields } = &mut state.sided_fields;
    fields.extend(started);
    *kept = Some(sides).filter(|_| !fields.is_empty());
    Ok(notes)
}

fn source<'a>(
    name: &Spanned<String>,
    state: &'a State,
    context: &Context,
) -> Result<Source<'a>, Error> {
    let text = name.get_ref();
    let find = |fields: &'a [Field]| fields.iter().find(|field| field.name == *text);
    let refused = |message: &str| Err(context.name_error(name, message));
    if find(&state.sided_fields.fields).is_some() {
        return Ok(Source::Sides);
    }
    match (find(&state.point_fields), find(&state.cell_fields)) {
        (None, Some(field)) => Ok(Source::Tets(field)),
        (Some(field), None) => Ok(Source::Vertices(field)),
        (Some(_), Some(_)) => refused(&format!(
            "both a field on vertices and one on tets are called `{text}`; rename one in the mesh file"
        )),
        (None, None) => {
            let fields = state.point_fields.iter().chain(&state.cell_fields);
            let mut names: Vec<&str> = fields.map(|field| field.name.as_str()).collect();
            names.sort_unstable();
            names.dedup();
            let valid = match names[..] {
                [] => ": the mesh file has no fields".into(),
                _ => suggestion(text, &names),
            };
            refused(&format!("no field is called `{text}`{valid}"))
        }
    }
}
