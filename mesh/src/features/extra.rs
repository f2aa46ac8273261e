//! Creases and corners that are asked for one by one.

use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::EDGES;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::ascending;

/// Edges and vertices of a coarsest mesh that are to be creases and corners,
/// besides those that are found. On the boundary or inside, they follow the
/// same rules as tagged ones.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ExtraFeatures {
    creases: Vec<[u32; 2]>,
    corners: Vec<u32>,
}

/// Why creases or corners cannot be as asked for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FeatureError {
    /// No simplex of the mesh has this edge.
    #[error(
        "the crease {}-{} is no edge of the mesh; name the two ends of an edge, counted from 0",
        ends[0],
        ends[1]
    )]
    NoEdge {
        /// The vertices that were named.
        ends: [u32; 2],
    },
    /// The mesh has fewer vertices.
    #[error(
        "the corner {vertex} is no vertex of the mesh, which has {vertices}; \
         name one from 0 to {}",
        vertices.saturating_sub(1)
    )]
    NoVertex {
        /// The vertex that was named.
        vertex: u32,
        /// How many there are.
        vertices: usize,
    },
}

impl ExtraFeatures {
    /// Checks edges (by their ends, in any order) and vertices against the mesh
    /// that is to be readied with them. Its numbers count, those after
    /// [`crate::check()`].
    ///
    /// # Errors
    /// For the first edge or vertex that the mesh does not have.
    pub fn new(
        mesh: &TetMesh,
        creases: &[[u32; 2]],
        corners: &[u32],
    ) -> Result<Self, FeatureError> {
        let vertices = mesh.points().len();
        if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices) {
            return Err(FeatureError::NoVertex { vertex, vertices });
        }
        let mut wanted: Vec<_> = creases.iter().map(|&ends| ascending(ends)).collect();
        wanted.sort_unstable();
        wanted.dedup();
        let is_edge = find_edges(mesh.raw(), &wanted);
        let missing = |&&ends: &&[u32; 2]| {
            !wanted.binary_search(&ascending(ends)).is_ok_and(|at| is_edge[at])
        };
        if let Some(&ends) = creases.iter().find(missing) {
            return Err(FeatureError::NoEdge { ends });
        }
        Ok(Self { creases: wanted, corners: corners.to_vec() })
    }

    /// The same edges and vertices of a mesh whose vertex v became `new[v]`.
    ///
    /// # Panics
    /// If `new` is shorter than the mesh has vertices.
    pub fn renumbered(&self, new: &[u32]) -> Self {
        let new = |v: u32| new[v as usize];
        let mut creases: Vec<_> = self.creases.iter().map(|e| ascending(e.map(new))).collect();
        creases.sort_unstable();
        Self { creases, corners: self.corners.iter().map(|&v| new(v)).collect() }
    }

    /// The edges, ends ascending.
    pub(super) fn creases(&self) -> &[[u32; 2]] {
        &self.creases
    }

    /// The vertices.
    pub(super) fn corners(&self) -> &[u32] {
        &self.corners
    }
}

/// Which of these sorted edges the mesh has; a few are looked for, so that
/// numbering all edges would be more work.
fn find_edges(mesh: &RawMesh, wanted: &[[u32; 2]]) -> Vec<bool> {
    let mut found = vec![false; wanted.len()];
    if wanted.is_empty() {
        return found;
    }
    let of_tets = mesh.tets.iter().flat_map(|tet| EDGES.map(|ends| ends.map(|v| tet[v])));
    let of_triangles =
        mesh.triangles.simplices.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    for ends in of_tets.chain(of_triangles).chain(mesh.edges.simplices.iter().copied()) {
        if let Ok(at) = wanted.binary_search(&ascending(ends)) {
            found[at] = true;
        }
    }
    found
}
