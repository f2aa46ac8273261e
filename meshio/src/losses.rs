//! What files of a format cannot hold of a dataset: a sentence for each loss, with
//! what the files are called.

use crate::dataset::{Dataset, Field};

/// Groups keep their ids, but not their names.
pub(crate) fn group_names(files: &str, dataset: &Dataset) -> Option<String> {
    let lost = !dataset.mesh.groups.is_empty();
    lost.then(|| format!("{files} files hold no group names; groups keep their ids only."))
}

/// Creases, corners and what else was found on the coarsest mesh.
pub(crate) fn features(files: &str, dataset: &Dataset) -> Option<String> {
    let lost = dataset.mesh.features.is_some();
    lost.then(|| format!("{files} files hold no features; they will be found anew."))
}

/// Vertices that belong to point groups.
pub(crate) fn tagged_vertices(files: &str, dataset: &Dataset) -> Option<String> {
    let count = dataset.mesh.vertices.len();
    (count > 0).then(|| {
        format!("{files} files hold no groups of points: {count} tagged vertices left out.")
    })
}

/// Fields of every sort.
pub(crate) fn fields(files: &str, dataset: &Dataset) -> Option<String> {
    let Dataset { point_fields, cell_fields, corner_fields, .. } = dataset;
    let names = names(point_fields.iter().chain(cell_fields).chain(corner_fields))?;
    Some(format!("{files} files hold no fields: {names} left out."))
}

/// Fields that may differ from tet to tet.
pub(crate) fn corner_fields(files: &str, dataset: &Dataset) -> Option<String> {
    let names = names(dataset.corner_fields.iter())?;
    Some(format!("{files} files hold no values at the corners of each tet: {names} left out."))
}

/// Which fields were computed from the mesh.
pub(crate) fn derived_marks(files: &str, dataset: &Dataset) -> Option<String> {
    let fields = dataset.point_fields.iter().chain(&dataset.cell_fields);
    let names = names(fields.filter(|field| field.derived))?;
    Some(format!(
        "{files} files do not tell data from what was computed from the mesh ({names}); refining \
         will carry both along."
    ))
}

fn names<'a>(fields: impl Iterator<Item = &'a Field>) -> Option<String> {
    let names: Vec<&str> = fields.map(|field| field.name.as_str()).collect();
    (!names.is_empty()).then(|| names.join(", "))
}
