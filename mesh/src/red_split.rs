//! The red split of a whole mesh: every tet into eight, with the fine mesh's
//! edges and faces taken over from the parents', in the order that sorting
//! from scratch would give.
//!
//! Fine vertices are the coarse ones, then the midpoint n + e of each edge e.
//! So the fine edges are, in lexicographic order,
//!
//! * the *halves* (v, n + e), in the order of [`VertexEdges`], then
//! * the *inner edges* (n + e, n + e'), grouped by e < e': three *cuts* a face
//!   (each cuts off one corner) and the *diagonal* of each tet;
//!
//! and the fine faces follow their first edge: three *corner faces* and a
//! *middle face* from each coarse face, eight *inner faces* from each tet.
//!
//! The coarse numbering is lexicographic, too, so nearly all of that order is
//! known without sorting. Let e = ab, a < b. The coarse faces that e is the
//! first edge of are (a, b, c) with c ascending, those that it is the middle
//! edge of (a, x, b) with x ascending, and then e < ac < bc and e < xb. What
//! remains to be sorted are one to five entries at a time.

mod children;
mod edges;
mod faces;
mod slots;

use crate::reference_tet::{EDGES, FACES, MARKING_PERMUTATIONS, PAIRS, edge_between};
use crate::topology::{EdgeFaces, Topology, VertexEdges};
use children::Children;
use edges::FineEdges;
use faces::FineFaces;

/// Fine tets, with their edges and faces.
pub(crate) struct RedSplit {
    pub tets: Vec<[u32; 4]>,
    pub topology: Topology,
}

/// The coarse tets, and the pair of each whose diagonal splits it.
pub(crate) struct Parents<'a> {
    pub tets: &'a [[u32; 4]],
    pub topology: &'a Topology,
    /// As in [`MARKING_PERMUTATIONS`]; without them, all split their marked pair.
    pub pairs: Option<&'a [u8]>,
}

/// Splits every tet; child k of tet t is tet 8 t + k.
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

impl Parents<'_> {
    fn pair(&self, tet: usize) -> usize {
        self.pairs.map_or(0, |pairs| usize::from(pairs[tet]))
    }

    /// The vertices of one tet, in the order that it is split in.
    #[inline]
    pub fn vertices(&self, tet: usize) -> [u32; 4] {
        match self.pair(tet) {
            0 => self.tets[tet],
            pair => MARKING_PERMUTATIONS[pair].map(|v| self.tets[tet][v]),
        }
    }

    /// One tet, reordered if it is to be split along another diagonal.
    #[inline]
    fn parent(&self, tet: usize) -> Parent {
        let (vertices, edges) = (self.tets[tet], self.topology.tet_edges[tet]);
        let faces = self.topology.tet_faces[tet];
        let pair = self.pair(tet);
        if pair == 0 {
            return Parent { tet, vertices, edges, faces };
        }
        self.reordered(tet, pair)
    }

    #[inline(never)]
    fn reordered(&self, tet: usize, pair: usize) -> Parent {
        let (vertices, edges) = (self.tets[tet], self.topology.tet_edges[tet]);
        let faces = self.topology.tet_faces[tet];
        let order = MARKING_PERMUTATIONS[pair];
        Parent {
            tet,
            vertices: order.map(|v| vertices[v]),
            edges: EDGES.map(|[a, b]| edges[edge_between(order[a], order[b])]),
            faces: order.map(|v| faces[v]),
        }
    }

    /// The edges whose midpoints the inner diagonal of a tet joins, ascending.
    fn split_pair(&self, tet: usize) -> [u32; 2] {
        let edges = &self.topology.tet_edges[tet];
        let [first, second] = PAIRS[self.pair(tet)];
        let (p, q) = (edges[first], edges[second]);
        [p.min(q), p.max(q)]
    }
}

/// A coarse tet with what its children's numbers are looked up from.
struct Parent {
    tet: usize,
    vertices: [u32; 4],
    edges: [u32; 6],
    faces: [u32; 4],
}

/// For each local face the places of its vertices in ascending order.
type Ranks = [[u8; 3]; 4];

impl Parent {
    /// The place of a local vertex among the ascending vertices of a local face.
    #[inline]
    fn rank(&self, face: usize, corner: usize) -> usize {
        let own = self.vertices[corner];
        let mut rank = 0;
        for v in FACES[face] {
            rank += usize::from(self.vertices[v] < own);
        }
        rank
    }

    #[inline]
    fn ranks(&self) -> Ranks {
        let mut ranks = [[0; 3]; 4];
        for (face, ranks) in ranks.iter_mut().enumerate() {
            for (corner, rank) in ranks.iter_mut().enumerate() {
                *rank = self.rank(face, FACES[face][corner]) as u8;
            }
        }
        ranks
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raw_mesh::RawMesh;
    use crate::shapes::{five_tet_cube, kuhn_box, regular_tet};

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
            let parents =
                Parents { tets: &mesh.tets, topology: &topology, pairs: pairs.as_deref() };
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
                *tet =
                    crate::reference_tet::MARKING_PERMUTATIONS[(t + shift) % 3].map(|v| moved[v]);
            }
            compare(raw);
        }
    }
}
