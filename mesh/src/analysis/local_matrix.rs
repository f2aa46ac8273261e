//! The square matrix that a scheme repeats round a vertex.

use nalgebra::DMatrix;

use super::error::AnalysisError;
use super::refined_star::RefinedStar;
use super::spectrum::Spectrum;
use crate::core::tet_mesh::TetMesh;
use crate::hierarchy::Hierarchy;
use crate::scheme::Scheme;

/// How often a star is split first. Rows of the four rings next to the centre
/// come from the two coarse rings next to it, and no rule reads more than two
/// rings further; so four rings always suffice.
const LEVELS: usize = 2;

/// The local subdivision matrix of a vertex: from the vertices of some rings
/// round it to those in the same places one level finer.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalMatrix {
    /// Row and column 0 are the vertex, then ring after ring; rows sum to one.
    pub matrix: DMatrix<f64>,
    /// How many rings the block has: the fewest whose rows read nothing else.
    pub rings: u32,
}

impl LocalMatrix {
    /// The matrix of a scheme at a vertex of a mesh, in its interior or on a
    /// surface or curve; a mesh without features counts as smooth.
    ///
    /// # Errors
    /// If there is no such vertex, or it has no tets.
    pub fn new(mesh: &TetMesh, vertex: u32, scheme: Scheme) -> Result<Self, AnalysisError> {
        let star = RefinedStar::new(mesh, vertex, LEVELS, scheme)?;
        let rings = star.closed_rings().expect("no rule reads more than two rings further");
        Ok(Self::of_rings(&star, rings))
    }

    /// The block of more rings than needed: it has the same eigenvalues and some
    /// more, which do not act on the limit at the vertex.
    ///
    /// # Errors
    /// As [`Self::new`], and if the rings are fewer than needed or more than
    /// four.
    pub fn with_rings(
        mesh: &TetMesh,
        vertex: u32,
        scheme: Scheme,
        rings: u32,
    ) -> Result<Self, AnalysisError> {
        let star = RefinedStar::new(mesh, vertex, LEVELS, scheme)?;
        let least = star.closed_rings().expect("no rule reads more than two rings further");
        let most = 1 << LEVELS;
        if !(least..=most).contains(&rings) {
            return Err(AnalysisError::Rings { rings, least, most });
        }
        Ok(Self::of_rings(&star, rings))
    }

    /// The block of a star's inner rings, which must be closed.
    fn of_rings(star: &RefinedStar, rings: u32) -> Self {
        let block = star.within(rings);
        let mut place = vec![None; star.layers.len()];
        block.iter().enumerate().for_each(|(i, &v)| place[v as usize] = Some(i));
        let mut matrix = DMatrix::zeros(block.len(), block.len());
        for (i, &vertex) in block.iter().enumerate() {
            for (column, weight) in star.row(vertex) {
                let j = place[column as usize].expect("closed rings read nothing beyond them");
                matrix[(i, j)] = weight;
            }
        }
        Self { matrix, rings }
    }

    /// The eigenvalues of the block.
    ///
    /// # Errors
    /// If the iteration does not end.
    pub fn spectrum(&self) -> Result<Spectrum, AnalysisError> {
        Spectrum::new(&self.matrix)
    }
}

/// The mesh split once linearly, and the number of an edge's midpoint there:
/// the place where a scheme's behaviour along an edge shows.
///
/// # Errors
/// If the two vertices share no edge, or the mesh cannot be split.
pub fn at_midpoint(mesh: &TetMesh, [a, b]: [u32; 2]) -> Result<(TetMesh, u32), AnalysisError> {
    let mut hierarchy = Hierarchy::new(mesh.clone(), &Default::default());
    let edge = hierarchy.coarsest().topology.edge_between(a, b);
    let edge = edge.ok_or(AnalysisError::NoEdge { ends: [a, b] })?;
    hierarchy.subdivide(Scheme::Linear)?;
    Ok((hierarchy.finest().mesh.clone(), mesh.points().len() as u32 + edge))
}
