//! Groups of the mesh by the names that configs use.

use octruss_mesh::RawMesh;
use toml::Spanned;

use super::Context;
use crate::error::Error;
use crate::recipe::suggestion;

/// The ids of the groups called `name` in dimension 2 (surfaces) or 3
/// (regions) that some simplex belongs to.
///
/// # Errors
/// A name that no group has (the message lists those there are), or an empty
/// group, with the place of the name in the config.
pub fn group_ids(
    mesh: &RawMesh,
    dimension: u8,
    name: &Spanned<String>,
    context: &Context,
) -> Result<Vec<i32>, Error> {
    let (what, of) = if dimension == 2 { ("surface", "triangle") } else { ("region", "tet") };
    let text = name.get_ref();
    let ids = mesh.group_ids(dimension, text);
    if ids.is_empty() {
        let names = mesh.group_names(dimension);
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let valid = match names[..] {
            [] => format!(": the mesh names no {what}s"),
            _ => suggestion(text, &names),
        };
        return Err(context.name_error(name, &format!("no {what} is called `{text}`{valid}")));
    }
    let in_use = mesh.ids(dimension);
    let ids: Vec<i32> = ids.into_iter().filter(|id| in_use.contains(id)).collect();
    if ids.is_empty() {
        let message = format!("the {what} `{text}` is empty: no {of} belongs to it");
        return Err(context.name_error(name, &message));
    }
    Ok(ids)
}
