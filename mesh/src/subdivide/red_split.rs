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

use std::borrow::Cow;

use rayon::prelude::*;

use crate::core::reference_tet::{EDGES, FACES, MARKED, MARKING_PERMUTATIONS, edge_between};
use crate::core::topology::{EdgeFaces, Topology, VertexEdges};
use children::Children;
use edges::FineEdges;
use faces::FineFaces;
use octruss_base::ragged::CHUNK;

/// Fine tets, with their edges and faces.
pub(crate) struct RedSplit {
    pub tets: Vec<[u32; 4]>,
    pub topology: Topology,
}

/// The coarse tets with their edges and faces, in the order that they are split
/// in: each along the diagonal of the pair that it marks then.
pub(crate) struct Parents<'a> {
    pub topology: &'a Topology,
    vertices: Cow<'a, [[u32; 4]]>,
    edges: Cow<'a, [[u32; 6]]>,
    faces: Cow<'a, [[u32; 4]]>,
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

impl<'a> Parents<'a> {
    /// Tets that are split along the diagonals of their marked pairs.
    pub fn marked(tets: &'a [[u32; 4]], topology: &'a Topology) -> Self {
        Self {
            topology,
            vertices: tets.into(),
            edges: (&topology.tet_edges[..]).into(),
            faces: (&topology.tet_faces[..]).into(),
        }
    }

    /// Tets that are split along the diagonals of these pairs, numbered as in
    /// [`MARKING_PERMUTATIONS`].
    pub fn along(tets: &[[u32; 4]], topology: &'a Topology, pairs: &[u8]) -> Self {
        let order = |tet: usize| MARKING_PERMUTATIONS[usize::from(pairs[tet])];
        let each = || (0..tets.len()).into_par_iter().with_min_len(CHUNK);
        let vertices: Vec<_> = each().map(|t| order(t).map(|v| tets[t][v])).collect();
        let faces: Vec<_> = each().map(|t| order(t).map(|v| topology.tet_faces[t][v])).collect();
        let edge = |t: usize, [a, b]: [usize; 2]| {
            topology.tet_edges[t][edge_between(order(t)[a], order(t)[b])]
        };
        let edges: Vec<_> = each().map(|t| EDGES.map(|ends| edge(t, ends))).collect();
        Self { topology, vertices: vertices.into(), edges: edges.into(), faces: faces.into() }
    }

    /// How many tets are split.
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// The vertices of one tet, in the order that it is split in.
    #[inline]
    pub fn vertices(&self, tet: usize) -> [u32; 4] {
        self.vertices[tet]
    }

    #[inline]
    fn parent(&self, tet: usize) -> Parent<'_> {
        let (vertices, edges) = (&self.vertices[tet], &self.edges[tet]);
        Parent { tet, vertices, edges, faces: &self.faces[tet] }
    }

    /// The edges whose midpoints the inner diagonal of a tet joins, ascending.
    fn split_pair(&self, tet: usize) -> [u32; 2] {
        let [p, q] = MARKED.map(|local| self.edges[tet][local]);
        [p.min(q), p.max(q)]
    }
}

/// A coarse tet with what its children's numbers are looked up from.
struct Parent<'a> {
    tet: usize,
    vertices: &'a [u32; 4],
    edges: &'a [u32; 6],
    faces: &'a [u32; 4],
}

/// For each local face the places of its vertices in ascending order.
type Ranks = [[u8; 3]; 4];

impl Parent<'_> {
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
