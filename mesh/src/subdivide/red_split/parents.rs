//! Coarse tets, as they are about to be split.

use std::borrow::Cow;

use rayon::prelude::*;

use crate::core::reference_tet::{EDGES, FACES, MARKED, MARKING_PERMUTATIONS, edge_between};
use crate::core::topology::Topology;
use octruss_base::ragged::CHUNK;

/// The coarse tets with their edges and faces, in the order that they are split
/// in: each along the diagonal of the pair that it marks then.
pub(crate) struct Parents<'a> {
    pub topology: &'a Topology,
    vertices: Cow<'a, [[u32; 4]]>,
    edges: Cow<'a, [[u32; 6]]>,
    faces: Cow<'a, [[u32; 4]]>,
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
    pub(super) fn parent(&self, tet: usize) -> Parent<'_> {
        let (vertices, edges) = (&self.vertices[tet], &self.edges[tet]);
        Parent { tet, vertices, edges, faces: &self.faces[tet] }
    }

    /// The edges whose midpoints the inner diagonal of a tet joins, ascending.
    pub(super) fn split_pair(&self, tet: usize) -> [u32; 2] {
        let [p, q] = MARKED.map(|local| self.edges[tet][local]);
        [p.min(q), p.max(q)]
    }
}

/// A coarse tet with what its children's numbers are looked up from.
pub(super) struct Parent<'a> {
    pub tet: usize,
    pub vertices: &'a [u32; 4],
    pub edges: &'a [u32; 6],
    pub faces: &'a [u32; 4],
}

/// For each local face the places of its vertices in ascending order.
pub(super) type Ranks = [[u8; 3]; 4];

impl Parent<'_> {
    /// The place of a local vertex among the ascending vertices of a local face.
    #[inline]
    pub fn rank(&self, face: usize, corner: usize) -> usize {
        let own = self.vertices[corner];
        let mut rank = 0;
        for v in FACES[face] {
            rank += usize::from(self.vertices[v] < own);
        }
        rank
    }

    #[inline]
    pub fn ranks(&self) -> Ranks {
        let mut ranks = [[0; 3]; 4];
        for (face, ranks) in ranks.iter_mut().enumerate() {
            for (corner, rank) in ranks.iter_mut().enumerate() {
                *rank = self.rank(face, FACES[face][corner]) as u8;
            }
        }
        ranks
    }
}
