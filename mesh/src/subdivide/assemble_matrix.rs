//! From a scheme's rules to the subdivision matrix of a whole mesh.

use crate::core::raw_mesh::RawMesh;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::{EdgeFaces, Topology, VertexEdges};
use crate::refinement::subdivision_matrix::{SubdivisionMatrix, linear_matrix};
use crate::scheme::Scheme;
use crate::subdivide::curve_ends::CurveEnds;
use crate::subdivide::rules::table::Rules;

/// The matrix of one step of a scheme on a mesh with its topology.
///
/// Curves have fixed ends. Its rows follow the mesh's features; a mesh without them counts as smooth.
pub fn subdivision_matrix(
    mesh: &TetMesh,
    topology: &Topology,
    scheme: Scheme,
) -> SubdivisionMatrix {
    let incidences = (&VertexEdges::new(topology), &EdgeFaces::new(topology));
    matrix_with(mesh.raw(), topology, incidences, (scheme, CurveEnds::Fixed))
}

/// The same, with the edges at each vertex and the faces at each edge at hand.
pub(crate) fn matrix_with(
    mesh: &RawMesh,
    topology: &Topology,
    incidences: (&VertexEdges, &EdgeFaces),
    (scheme, curve_ends): (Scheme, CurveEnds),
) -> SubdivisionMatrix {
    if scheme == Scheme::Linear {
        return linear_matrix(topology);
    }
    let n = topology.vertex_count();
    let rules = Rules::new(mesh, topology, incidences, scheme, curve_ends);
    SubdivisionMatrix::from_rows(n + topology.edges().len(), n, |row, entries| {
        match row.checked_sub(n) {
            None => rules.vertex_row(row as u32, entries),
            Some(edge) => rules.edge_row(edge as u32, entries),
        }
    })
}
