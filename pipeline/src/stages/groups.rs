//! Groups of the mesh by the names that configs use.

use octruss_mesh::RawMesh;

use crate::recipe::suggestion;

/// The ids of the groups called `name` in dimension 2 (surfaces) or 3
/// (regions) that some simplex belongs to.
///
/// # Errors
/// A name that no group has (the message lists those there are), or an empty group.
pub fn group_ids(mesh: &RawMesh, dimension: u8, name: &str) -> Result<Vec<i32>, String> {
    let (what, of) = if dimension == 2 { ("surface", "triangle") } else { ("region", "tet") };
    let ids = mesh.group_ids(dimension, name);
    if ids.is_empty() {
        let valid = mesh.group_names(dimension);
        if valid.is_empty() {
            return Err(format!("no {what} is called `{name}`: the mesh names no {what}s"));
        }
        let valid: Vec<&str> = valid.iter().map(String::as_str).collect();
        return Err(format!("no {what} is called `{name}`{}", suggestion(name, &valid)));
    }
    let in_use = mesh.ids(dimension);
    let ids: Vec<i32> = ids.into_iter().filter(|id| in_use.contains(id)).collect();
    if ids.is_empty() {
        return Err(format!("the {what} `{name}` is empty: no {of} belongs to it"));
    }
    Ok(ids)
}
