//! From coarse tets to fine ones, their edges and their faces.

use super::children::Children;
use super::edges::FineEdges;
use super::faces::FineFaces;
use super::parents::Parents;
use crate::core::topology::{EdgeFaces, Topology, VertexEdges};

/// Fine tets, with their edges and faces; the children of each coarse tet follow
/// one another.
pub(crate) struct RedSplit {
    pub tets: Vec<[u32; 4]>,
    pub topology: Topology,
}

/// Splits every tet.
pub(crate) fn red_split(
    coarse: &Parents,
    vertex_edges: &VertexEdges,
    edge_faces: &EdgeFaces,
) -> RedSplit {
    let edges = FineEdges::new(coarse, vertex_edges, edge_faces);
    let faces = FineFaces::new(coarse, &edges, vertex_edges);
    let children = Children::new(coarse, &edges, &faces);
    let topology = Topology {
        edges: edges.edges,
        first_edges: edges.first_edges,
        faces: faces.faces,
        first_faces: faces.first_faces,
        face_edges: faces.face_edges,
        face_tets: faces.face_tets,
        tet_edges: children.edges,
        tet_faces: children.faces,
    };
    RedSplit { tets: children.tets, topology }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::raw_mesh::RawMesh;
    use crate::core::shapes::{five_tet_cube, kuhn_box, regular_tet};

    /// Twice split, the topology from the parents equals that from scratch;
    /// along the marked diagonals or along any others.
    fn compare(mesh: RawMesh) {
        let mesh = RawMesh { triangles: Default::default(), ..mesh };
        compare_along(mesh.clone(), |_| None);
        compare_along(mesh, |tets| Some((0..tets).map(|t| (t * t % 7 % 3) as u8).collect()));
    }

    fn compare_along(mut mesh: RawMesh, pairs: fn(usize) -> Option<Vec<u8>>) {
        let mut topology = Topology::new(&mesh);
        for _ in 0..2 {
            let pairs = pairs(mesh.tets.len());
            let parents = match &pairs {
                None => Parents::marked(&mesh.tets, &topology),
                Some(pairs) => Parents::along(&mesh.tets, &topology, pairs),
            };
            let (vertex_edges, edge_faces) =
                (VertexEdges::new(&topology), EdgeFaces::new(&topology));
            let split = red_split(&parents, &vertex_edges, &edge_faces);
            mesh.points.resize(mesh.points.len() + topology.edges.len(), [0.0; 3]);
            mesh.tets = split.tets;
            topology = Topology::new(&mesh);
            assert!(split.topology == topology);
        }
    }

    #[test]
    fn topology_from_the_parents_equals_topology_from_scratch() {
        for mesh in [regular_tet(), five_tet_cube(), kuhn_box([2, 1, 3], [1.0; 3])] {
            compare(mesh.into_raw());
        }
    }

    #[test]
    fn vertex_numbers_and_orders_in_any_arrangement_are_handled() {
        // The five-tet cube under each rotation of vertex numbers, with each
        // tet's vertices permuted evenly in a way that differs from tet to tet.
        for shift in 0..8 {
            let mut raw = five_tet_cube().into_raw();
            raw.points.rotate_right(shift);
            for (t, tet) in raw.tets.iter_mut().enumerate() {
                let moved = tet.map(|v| (v + shift as u32) % 8);
                *tet = crate::core::reference_tet::MARKING_PERMUTATIONS[(t + shift) % 3]
                    .map(|v| moved[v]);
            }
            compare(raw);
        }
    }
}
