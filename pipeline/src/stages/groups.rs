//! Groups of the mesh by the names that configs use.

use octruss_base::suggestion::suggestion;
use octruss_fem::ByRegion;
use octruss_mesh::RawMesh;
use toml::Spanned;

use super::context::Context;
use crate::error::Error;
use crate::options::PerRegion;

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

/// What a config gives by region name, by region id; `otherwise` where it gives
/// nothing.
///
/// # Errors
/// As [`group_ids`]; a region of the mesh that is called as the table's entry
/// for all others.
pub fn by_region<T, U: Clone>(
    given: &PerRegion<T>,
    convert: impl Fn(&T) -> U,
    otherwise: U,
    mesh: &RawMesh,
    context: &Context,
) -> Result<ByRegion<U>, Error> {
    let named = match given {
        PerRegion::Uniform(value) => return Ok(ByRegion::from(convert(value))),
        PerRegion::Named(named) => named,
    };
    let (mut default, mut regions) = (otherwise, Vec::new());
    for (name, value) in named {
        let value = convert(value);
        if name.get_ref() != PerRegion::<T>::DEFAULT {
            let ids = group_ids(mesh, 3, name, context)?;
            regions.extend(ids.into_iter().map(|id| (id, value.clone())));
        } else if mesh.group_ids(3, PerRegion::<T>::DEFAULT).is_empty() {
            default = value;
        } else {
            let message = "`default` stands for all regions that are not named, but a region of \
                the mesh is called so, too: rename that region, or name all others instead";
            return Err(context.name_error(name, message));
        }
    }
    Ok(ByRegion { default, regions })
}

/// What a config gives by surface name, by surface id, in the order given.
///
/// # Errors
/// As [`group_ids`].
pub fn on_surfaces<'a, T: Clone>(
    given: impl Iterator<Item = (&'a Spanned<String>, T)>,
    mesh: &RawMesh,
    context: &Context,
) -> Result<Vec<(i32, T)>, Error> {
    let mut all = Vec::new();
    for (surface, value) in given {
        let ids = group_ids(mesh, 2, surface, context)?;
        all.extend(ids.into_iter().map(|id| (id, value.clone())));
    }
    Ok(all)
}
