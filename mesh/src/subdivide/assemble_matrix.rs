//! From a scheme's rules to the subdivision matrix of a whole mesh.

use crate::core::raw_mesh::RawMesh;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::{EdgeFaces, Topology, VertexEdges};
use crate::refinement::subdivision_matrix::{SubdivisionMatrix, linear_matrix};
use crate::scheme::Scheme;
use crate::subdivide::neighbourhoods::Neighbourhoods;
use crate::subdivide::rules;

/// The matrix of one step of a scheme on a mesh with its topology.
///
/// Its rows follow the mesh's features; a mesh without them counts as smooth.
pub fn subdivision_matrix(
    mesh: &TetMesh,
    topology: &Topology,
    scheme: Scheme,
) -> SubdivisionMatrix {
    let incidences = (&VertexEdges::new(topology), &EdgeFaces::new(topology));
    matrix_with(mesh.raw(), topology, incidences, scheme)
}

/// The same, with the edges at each vertex and the faces at each edge at hand.
pub(crate) fn matrix_with(
    mesh: &RawMesh,
    topology: &Topology,
    (vertex_edges, edge_faces): (&VertexEdges, &EdgeFaces),
    scheme: Scheme,
) -> SubdivisionMatrix {
    if scheme == Scheme::Linear {
        return linear_matrix(topology);
    }
    let n = topology.vertex_count();
    let near = Neighbourhoods::new(mesh, topology, (vertex_edges, edge_faces), scheme);
    SubdivisionMatrix::from_rows(n + topology.edges().len(), n, |row, entries| {
        match row.checked_sub(n) {
            None => rules::vertex_row(scheme, &near, row as u32, entries),
            Some(edge) => rules::edge_row(scheme, &near, edge as u32, entries),
        }
    })
}
