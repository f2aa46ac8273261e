//! From a scheme's rules to the subdivision matrix of a whole mesh.

use crate::core::curve_ends::CurveEnds;
use crate::core::mirrors::Unfolded;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::{EdgeFaces, Topology, VertexEdges};
use crate::refinement::folded::folded;
use crate::refinement::subdivision_matrix::{SubdivisionMatrix, linear_matrix};
use crate::scheme::Scheme;
use crate::subdivide::rules::table::Rules;

/// The matrix of one step of a scheme on a mesh with its topology.
///
/// Curves have fixed ends. Its rows follow the mesh's features; a mesh without them counts as smooth.
/// Beside mirror planes rows are those for fields, see [`crate::Refinement::mirrored`].
pub fn subdivision_matrix(
    mesh: &TetMesh,
    topology: &Topology,
    scheme: Scheme,
) -> SubdivisionMatrix {
    if scheme == Scheme::Linear {
        return linear_matrix(topology);
    }
    let unfolded = Unfolded::new(mesh.raw(), topology);
    folded(unfolded_matrix(&unfolded, (scheme, CurveEnds::Fixed)), &unfolded)
}

/// The rows of a mesh's own vertices and edges; columns are unfolded vertices.
pub(crate) fn unfolded_matrix(
    unfolded: &Unfolded,
    rules: (Scheme, CurveEnds),
) -> SubdivisionMatrix {
    let topology = &*unfolded.topology;
    matrix_with(unfolded, (&VertexEdges::new(topology), &EdgeFaces::new(topology)), rules)
}

/// The same, with the edges at each vertex and the faces at each edge of the unfolded mesh
/// at hand.
pub(crate) fn matrix_with(
    unfolded: &Unfolded,
    incidences: (&VertexEdges, &EdgeFaces),
    (scheme, curve_ends): (Scheme, CurveEnds),
) -> SubdivisionMatrix {
    if scheme == Scheme::Linear && !unfolded.has_mirrors() {
        return linear_matrix(&unfolded.topology);
    }
    let n = unfolded.vertices();
    let columns = unfolded.topology.vertex_count();
    let rules = Rules::new(&unfolded.mesh, &unfolded.topology, incidences, scheme, curve_ends);
    SubdivisionMatrix::from_rows(n + unfolded.edges(), columns, |row, entries| {
        match row.checked_sub(n) {
            None => rules.vertex_row(row as u32, entries),
            Some(edge) => rules.edge_row(unfolded.edge(edge), entries),
        }
    })
}
