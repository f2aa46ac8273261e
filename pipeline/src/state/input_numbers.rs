//! Where the vertices and tets of a level are in the mesh file.

use octruss_mesh::{Refinement, Renumbering};
use octruss_meshio::{Dataset, Field, Values};

use super::derived_fields::DerivedFields;

/// The field that tells the number of each vertex.
const VERTEX: &str = "input-vertex";

/// The field that tells the number of each tet.
const TET: &str = "input-tet";

/// The number of a vertex that the file does not have.
const MADE: i64 = -1;

/// For a level, the number of each vertex and tet in the mesh file,
/// from 0; tets are counted among tets.
///
/// A file that was written by an earlier run and records features carries these
/// numbers, too: they go on meaning the file that was first refined.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct InputNumbers {
    vertices: Vec<i64>,
    tets: Vec<i64>,
}

impl InputNumbers {
    /// The numbers that a file has or gives its vertices and tets.
    pub fn of(dataset: &Dataset) -> Self {
        let refined = dataset.mesh.features.is_some();
        let recorded = |fields: &[Field], name: &str, count: usize| {
            fields
                .iter()
                .filter(|field| refined && field.derived && field.name == name)
                .find_map(|field| match &field.values {
                    Values::Integer(numbers) if numbers.len() == count => Some(numbers.clone()),
                    _ => None,
                })
                .unwrap_or_else(|| (0..count as i64).collect())
        };
        let Dataset { mesh, point_fields, cell_fields, .. } = dataset;
        Self {
            vertices: recorded(point_fields, VERTEX, mesh.points.len()),
            tets: recorded(cell_fields, TET, mesh.tets.len()),
        }
    }

    /// Those of the vertices that checking kept.
    pub fn keep_vertices(&mut self, kept: &[u32]) {
        self.vertices = pick(&self.vertices, kept);
    }

    /// Follows the mesh to its new numbers.
    pub fn renumber(&mut self, from: &Renumbering) {
        self.vertices = pick(&self.vertices, &from.vertices);
        self.tets = pick(&self.tets, &from.tets);
    }

    /// Those of a finer level: new vertices have −1, tets the number of their ancestor.
    pub fn refined<'a>(&self, refinements: impl IntoIterator<Item = &'a Refinement>) -> Self {
        let down = |numbers: Self, refinement: &Refinement| {
            let Self { mut vertices, tets } = numbers;
            vertices.resize(refinement.ancestry.fine_vertices(), MADE);
            Self { vertices, tets: refinement.inherit(&tets, 1) }
        };
        refinements.into_iter().fold(self.clone(), down)
    }

    /// The numbers as fields of the level that they are of.
    pub fn fields(self) -> DerivedFields {
        DerivedFields {
            points: vec![Field::derived(VERTEX, Values::Integer(self.vertices))],
            cells: vec![Field::derived(TET, Values::Integer(self.tets))],
        }
    }
}

fn pick(numbers: &[i64], from: &[u32]) -> Vec<i64> {
    from.iter().map(|&old| numbers[old as usize]).collect()
}
