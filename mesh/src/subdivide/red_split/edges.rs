//! The edges of the red-refined mesh, in order.

use rayon::prelude::*;

use super::parents::Parents;
use crate::core::topology::{EdgeFaces, Topology, VertexEdges};
use octruss_base::groups::Groups;
use octruss_base::large_array::zeroed;
use octruss_base::ragged::{self, CHUNK};

/// The fine edges, and where each coarse edge, face and tet finds its own.
pub(super) struct FineEdges<'a> {
    pub edges: Vec<[u32; 2]>,
    pub first_edges: Vec<u32>,
    /// For each coarse edge the halves at its lower and higher end.
    pub halves: Vec<[u32; 2]>,
    /// For each coarse face a < b < c the edges that cut off a, b and c.
    pub cuts: Vec<[u32; 3]>,
    /// For each tet its inner diagonal.
    pub diagonals: Vec<u32>,
    pub inner: InnerEdges<'a>,
}

/// The inner edges (n + e, n + e') by the smaller coarse edge e.
///
/// Those of e = ab are, in ascending order of e': one to each ac of the faces
/// (a, b, c), then one to each xb of the faces (a, x, b), then one to each bc of
/// the faces (a, b, c); and among the latter two the diagonals to edges opposite
/// to e.
pub(super) struct InnerEdges<'a> {
    /// The first one of each coarse edge, counted from the first inner edge.
    pub firsts: Vec<u32>,
    /// The faces at each coarse edge.
    pub edge_faces: &'a EdgeFaces<'a>,
    /// For each coarse edge the greater edges opposite to it, with the tet
    /// whose diagonal joins them, ascending.
    diagonals: Groups<(u32, u32)>,
}

/// Where an inner edge comes from.
#[derive(Clone, Copy)]
pub(super) enum Inner {
    /// Cuts off the corner a, b or c (0, 1, 2) of the face a < b < c.
    Cut { face: u32, corner: usize },
    /// The diagonal of a tet.
    Diagonal { tet: u32 },
}

impl<'a> InnerEdges<'a> {
    fn new(parents: &Parents, edge_faces: &'a EdgeFaces<'a>) -> Self {
        let coarse = parents.topology;
        let diagonal = |tet: usize| {
            let [low, high] = parents.split_pair(tet);
            [(low, (high, tet as u32))]
        };
        let diagonals = Groups::new(coarse.edges.len(), parents.len(), diagonal).sort();
        let count = |edge: usize| {
            let faces =
                2 * coarse.faces_from(edge as u32).len() + edge_faces.middle(edge as u32).len();
            faces + diagonals.of(edge).len()
        };
        Self { firsts: ragged::offsets(coarse.edges.len(), count), edge_faces, diagonals }
    }

    /// The inner edges of a coarse edge e, in order: e' and where it comes from.
    pub fn of(&self, coarse: &Topology, edge: u32, mut each: impl FnMut(u32, Inner)) {
        let from = coarse.faces_from(edge);
        for face in from.clone() {
            each(coarse.face_edges[face as usize][1], Inner::Cut { face, corner: 0 });
        }
        let mut diagonals = self.diagonals.of(edge as usize);
        let middle = self.edge_faces.middle(edge).iter().map(|&face| (face, 2));
        for (face, corner) in middle.chain(from.map(|face| (face, 1))) {
            let other = coarse.face_edges[face as usize][2];
            while let Some((&(high, tet), rest)) = diagonals.split_first()
                && high < other
            {
                each(high, Inner::Diagonal { tet });
                diagonals = rest;
            }
            each(other, Inner::Cut { face, corner });
        }
        diagonals.iter().for_each(|&(high, tet)| each(high, Inner::Diagonal { tet }));
    }

    /// The edges that cut off the corners of a face, counted from the first inner edge.
    fn cuts(&self, coarse: &Topology, face: u32) -> [u32; 3] {
        let [ab, ac, bc] = coarse.face_edges[face as usize];
        let [at_ab, at_ac] = [ab, ac].map(|edge| self.firsts[edge as usize]);
        let [from_ab, from_ac] = [ab, ac].map(|edge| coarse.faces_from(edge).len() as u32);
        let place = face - coarse.first_faces[ab as usize];
        let rank = self.edge_faces.rank_in_middle(ac, face);
        let diagonals_before = |edge: u32| {
            let diagonals = self.diagonals.of(edge as usize).iter();
            diagonals.take_while(|&&(high, _)| high < bc).count() as u32
        };
        let after_middle = from_ab + self.edge_faces.middle(ab).len() as u32;
        [
            at_ab + place,
            at_ab + after_middle + place + diagonals_before(ab),
            at_ac + from_ac + rank + diagonals_before(ac),
        ]
    }
}

impl<'a> FineEdges<'a> {
    pub fn new(
        parents: &Parents,
        vertex_edges: &VertexEdges,
        edge_faces: &'a EdgeFaces<'a>,
    ) -> Self {
        let coarse = parents.topology;
        let (n, half_count) = (coarse.vertex_count() as u32, 2 * coarse.edges.len() as u32);
        let inner = InnerEdges::new(parents, edge_faces);
        let total = half_count + inner.firsts[coarse.edges.len()];
        let mut edges: Vec<[u32; 2]> = zeroed(total as usize);
        let (halves, inner_edges) = edges.split_at_mut(half_count as usize);
        ragged::for_each(vertex_edges.offsets(), halves, |first, last, halves| {
            let ends = (first..last)
                .flat_map(|v| vertex_edges.of(v).iter().map(move |&e| [v as u32, n + e]));
            halves.iter_mut().zip(ends).for_each(|(half, ends)| *half = ends);
        });
        ragged::for_each(&inner.firsts, inner_edges, |first, last, edges| {
            let mut slots = edges.iter_mut();
            for edge in first as u32..last as u32 {
                inner.of(coarse, edge, |other, _| {
                    *slots.next().expect("as many as counted") = [n + edge, n + other];
                });
            }
        });
        let mut first_edges: Vec<u32> = zeroed(n as usize + coarse.edges.len() + 1);
        first_edges[..n as usize].copy_from_slice(&vertex_edges.offsets()[..n as usize]);
        let firsts = first_edges[n as usize..].iter_mut().zip(&inner.firsts);
        firsts.for_each(|(slot, first)| *slot = half_count + first);
        let mut cuts: Vec<[u32; 3]> = zeroed(coarse.faces.len());
        cuts.par_iter_mut().with_min_len(CHUNK).enumerate().for_each(|(face, cuts)| {
            *cuts = inner.cuts(coarse, face as u32).map(|cut| half_count + cut);
        });
        let diagonals = diagonals(parents, &edges, &first_edges[n as usize..], n);
        let halves = vertex_edges.places(coarse);
        Self { edges, first_edges, halves, cuts, diagonals, inner }
    }
}

/// The diagonal of each tet, looked up in the list of its smaller edge.
fn diagonals(parents: &Parents, edges: &[[u32; 2]], firsts: &[u32], n: u32) -> Vec<u32> {
    let mut diagonals: Vec<u32> = zeroed(parents.len());
    diagonals.par_iter_mut().with_min_len(CHUNK).enumerate().for_each(|(tet, diagonal)| {
        let [low, high] = parents.split_pair(tet);
        let [first, last] = [low, low + 1].map(|edge| firsts[edge as usize] as usize);
        let at = edges[first..last].partition_point(|&[_, other]| other < n + high);
        *diagonal = (first + at) as u32;
    });
    diagonals
}
