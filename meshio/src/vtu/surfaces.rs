//! The tagged triangles of a dataset as a file of their own, to look at.

use std::path::{Path, PathBuf};

use super::document::{Array, Document, VtuOptions};
use super::number::NumberType::Int32;
use super::own_points::OwnPoints;
use super::write::{cells, positions};
use crate::cell_kind::Simplex;
use crate::dataset::{Dataset, Field};
use crate::error::Error;
use crate::field_data;
use octruss_mesh::Group;

/// The cell array with the surface group of each triangle.
const SURFACE: &str = "surface";

/// Where the surfaces of the file at `path` go: `NAME.surfaces.vtu` beside it.
///
/// ```
/// use std::path::Path;
/// let beside = octruss_meshio::vtu::surfaces_path(Path::new("out/part.vtu"));
/// assert_eq!(beside, Path::new("out/part.surfaces.vtu"));
/// ```
pub fn surfaces_path(path: &Path) -> PathBuf {
    path.with_extension("surfaces.vtu")
}

/// Writes the tagged triangles as a VTU file of triangles at `path` (usually
/// [`surfaces_path`]): the points that they use, with the point fields there,
/// and the cell array `surface` (Int32) with their group ids. The names of the
/// surface groups are in `FieldData`.
///
/// # Errors
/// As [`super::write_with`]; and [`Error::Unsupported`] if a triangle has a
/// vertex beyond the points.
pub fn write_surfaces(path: &Path, dataset: &Dataset) -> Result<(), Error> {
    let surfaces = Surfaces::of(dataset).map_err(|message| Error::unsupported(path, message))?;
    let document = surfaces.document().map_err(|message| Error::unsupported(path, message))?;
    document.write(path, &VtuOptions::default())
}

/// The tagged triangles with points of their own.
struct Surfaces {
    points: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    tags: Vec<i32>,
    fields: Vec<Field>,
    groups: Vec<Group>,
}

impl Surfaces {
    fn of(dataset: &Dataset) -> Result<Self, String> {
        dataset.check_lengths()?;
        let mesh = &dataset.mesh;
        let vertices = mesh.triangles.simplices.as_flattened().iter().copied();
        let own = OwnPoints::used(vertices, mesh.points.len(), "a tagged triangle")?;
        Ok(Self {
            points: own.of(&mesh.points),
            triangles: own.renumber(mesh.triangles.simplices.iter()),
            tags: mesh.triangles.tags.clone(),
            fields: dataset
                .point_fields
                .iter()
                .map(|field| field.subset(own.kept.iter().copied()))
                .collect(),
            groups: mesh.groups.iter().filter(|g| g.dimension == 2).cloned().collect(),
        })
    }

    fn document(&self) -> Result<Document<'_>, String> {
        let side = field_data::group_arrays(&self.groups)?;
        Ok(Document {
            points: self.points.len(),
            cells: self.triangles.len(),
            field_data: side.into_iter().map(Array::side).collect(),
            point_data: self.fields.iter().map(Array::field).collect(),
            cell_data: vec![Array::numbers(SURFACE, Int32, 1, self.tags.as_slice())],
            positions: vec![positions(&self.points)],
            topology: cells(&self.triangles, Simplex::Triangle),
        })
    }
}
