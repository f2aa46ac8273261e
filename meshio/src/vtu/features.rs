//! The curves and points that subdivision keeps, as a file to look at.

use std::path::Path;

use super::document::{Array, Document, VtuOptions};
use super::number::NumberType::{Int32, Int64, UInt8};
use super::own_points::OwnPoints;
use super::write::positions;
use crate::cell_kind::Simplex;
use crate::error::Error;
use crate::field_data;
use octruss_mesh::{FeatureReasons, Group, Reason, TetMesh};

/// Writes the point and curve strata of a mesh as a VTU file of vertices and
/// lines: the points that they use, and the cell arrays `stratum` (0 for fixed
/// points, 1 for curves) and `reason` (the [`Reason::code`]). The names of the
/// reasons are those of groups in `FieldData`. A mesh without such features
/// gives a file without cells.
///
/// # Errors
/// [`Error::Io`] if the folder or file cannot be written; [`Error::Unsupported`]
/// if a feature has a vertex that the mesh does not.
pub fn write_features(path: &Path, mesh: &TetMesh, reasons: &FeatureReasons) -> Result<(), Error> {
    let vertices: Vec<[u32; 1]> = reasons.points.iter().map(|&(vertex, _)| [vertex]).collect();
    let lines: Vec<[u32; 2]> = reasons.curves.iter().map(|&(ends, _)| ends).collect();
    let used = vertices.as_flattened().iter().chain(lines.as_flattened()).copied();
    let own = OwnPoints::used(used, mesh.points().len(), "a feature")
        .map_err(|message| Error::unsupported(path, message))?;
    let skeleton = Skeleton {
        points: own.of(mesh.points()),
        vertices: own.renumber(vertices.iter()),
        lines: own.renumber(lines.iter()),
        reasons: [
            reasons.points.iter().map(|point| point.1).collect(),
            reasons.curves.iter().map(|curve| curve.1).collect(),
        ],
    };
    let groups = skeleton.groups();
    let side =
        field_data::group_arrays(&groups).map_err(|message| Error::unsupported(path, message))?;
    let document =
        Document { field_data: side.into_iter().map(Array::side).collect(), ..skeleton.document() };
    document.write(path, &VtuOptions::default())
}

/// Vertices, then lines, with points of their own.
struct Skeleton {
    points: Vec<[f64; 3]>,
    vertices: Vec<[u32; 1]>,
    lines: Vec<[u32; 2]>,
    /// Of the vertices and of the lines.
    reasons: [Vec<Reason>; 2],
}

impl Skeleton {
    /// The reasons in use, as groups of their dimension.
    fn groups(&self) -> Vec<Group> {
        let of = |dimension: u8| {
            let mut used = self.reasons[usize::from(dimension)].clone();
            used.sort_unstable();
            used.dedup();
            used.into_iter().map(move |reason| Group {
                dimension,
                id: reason.code().into(),
                name: reason.name().into(),
            })
        };
        of(0).chain(of(1)).collect()
    }

    fn document(&self) -> Document<'_> {
        let (vertices, lines) = (self.vertices.len(), self.lines.len());
        let strata = [vec![0i32; vertices], vec![1; lines]].concat();
        let codes: Vec<i32> =
            self.reasons.iter().flatten().map(|reason| reason.code().into()).collect();
        let corners = self.vertices.as_flattened().iter().chain(self.lines.as_flattened());
        let connectivity: Vec<i64> = corners.copied().map(i64::from).collect();
        let ends = (1..=vertices).chain((1..=lines).map(|line| vertices + 2 * line));
        let ends: Vec<i64> = ends.map(|end| end as i64).collect();
        let [vertex, line] = [Simplex::Vertex, Simplex::Edge].map(Simplex::vtk_number);
        let types = [vec![vertex; vertices], vec![line; lines]].concat();
        Document {
            points: self.points.len(),
            cells: vertices + lines,
            field_data: Vec::new(),
            point_data: Vec::new(),
            cell_data: vec![
                Array::numbers("stratum", Int32, 1, strata),
                Array::numbers("reason", Int32, 1, codes),
            ],
            positions: vec![positions(&self.points)],
            topology: vec![
                Array::numbers("connectivity", Int64, 1, connectivity),
                Array::numbers("offsets", Int64, 1, ends),
                Array::numbers("types", UInt8, 1, types),
            ],
        }
    }
}
