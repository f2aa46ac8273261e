//! A star refined towards its centre, and one step of a scheme on it.

use super::error::AnalysisError;
use super::place;
use super::star::star;
use crate::core::tet_mesh::TetMesh;
use crate::hierarchy::Hierarchy;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::scheme::Scheme;
use crate::subdivide::assemble_matrix::subdivision_matrix;

/// A star after some linear splits, with the matrix of a scheme's next step.
///
/// A child at a corner keeps its parent's marking, so the surroundings of the
/// centre are the same at every level, half the size. A vertex of the mesh and
/// the one in the same place a level finer make a row and a column of the
/// local matrix.
pub(crate) struct RefinedStar {
    /// Vertex 0 is the centre.
    pub mesh: TetMesh,
    /// For each vertex how many edges lead to the centre.
    pub layers: Vec<u32>,
    /// One step of the scheme from the mesh.
    matrix: SubdivisionMatrix,
    /// For each vertex the row of the one in the same place a level finer.
    rows: Vec<u32>,
}

impl RefinedStar {
    /// Refines the star of a vertex to 2^levels layers.
    pub fn new(
        mesh: &TetMesh,
        vertex: u32,
        levels: usize,
        scheme: Scheme,
    ) -> Result<Self, AnalysisError> {
        let mut hierarchy = Hierarchy::new(star(mesh, vertex)?, &Default::default());
        let mut places = place::initial(hierarchy.finest().mesh.points().len());
        for level in 0..levels {
            hierarchy.subdivide(Scheme::Linear)?;
            places = place::refined(&places, &hierarchy.levels()[level].topology);
        }
        let topology = &hierarchy.levels()[levels].topology;
        let fine_places = place::refined(&places, topology);
        let mut by_place: Vec<u32> = (0..fine_places.len() as u32).collect();
        by_place.sort_unstable_by_key(|&row| &fine_places[row as usize]);
        let row_at = |place| {
            let found = by_place.binary_search_by_key(&place, |&row| &fine_places[row as usize]);
            by_place[found.expect("a finer star has a vertex in every place of a coarser one")]
        };
        Ok(Self {
            layers: places.iter().map(place::Place::layer).collect(),
            rows: places.iter().map(row_at).collect(),
            matrix: subdivision_matrix(&hierarchy.finest().mesh, topology, scheme),
            mesh: hierarchy.into_finest().mesh,
        })
    }

    /// What the vertex in the same place one level finer is made of.
    pub fn row(&self, vertex: u32) -> impl Iterator<Item = (u32, f64)> {
        let (columns, weights) = self.matrix.row(self.rows[vertex as usize] as usize);
        columns.iter().copied().zip(weights.iter().copied())
    }

    /// The vertices up to a layer, the nearest first.
    pub fn within(&self, rings: u32) -> Vec<u32> {
        let mut vertices: Vec<u32> =
            (0..self.layers.len() as u32).filter(|&v| self.layers[v as usize] <= rings).collect();
        vertices.sort_by_key(|&v| self.layers[v as usize]);
        vertices
    }

    /// The smallest number of rings whose rows read nothing beyond them.
    pub fn closed_rings(&self) -> Option<u32> {
        let reach = |vertex| self.row(vertex).map(|(column, _)| self.layers[column as usize]).max();
        let outermost = self.layers.iter().copied().max()?;
        (1..=outermost)
            .find(|&rings| self.within(rings).into_iter().all(|v| reach(v) <= Some(rings)))
    }
}
