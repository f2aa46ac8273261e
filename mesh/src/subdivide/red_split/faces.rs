//! The faces of the red-refined mesh, in order.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use rayon::prelude::*;

use super::edges::{FineEdges, Inner};
use super::parents::{Parent, Parents};
use super::parts::child_of;
use super::slots::{
    BETWEEN, CUTS, DIAGONAL, INNER_CHILDREN, INNER_FACES, MIDDLE_CHILD, beside_diagonal,
};
use crate::core::reference_tet::MARKED;
use crate::core::topology::{NONE, VertexEdges};
use octruss_base::large_array::{defaults, zeroed};
use octruss_base::ragged::{self, CHUNK};

/// The fine faces, and where each coarse face and tet finds its own.
pub(super) struct FineFaces {
    pub faces: Vec<[u32; 3]>,
    pub first_faces: Vec<u32>,
    pub face_edges: Vec<[u32; 3]>,
    pub face_tets: Vec<[u32; 2]>,
    /// For each coarse face its parts at the ascending corners.
    pub parts: Vec<[u32; 3]>,
    /// For each coarse face its middle part. (Written once each, by whoever
    /// makes the face; so relaxed stores suffice.)
    pub middles: Vec<AtomicU32>,
    /// For each tet the faces inside it.
    pub inner: Vec<[AtomicU32; INNER_FACES]>,
}

/// A fine face by the last of the three coarse edges whose midpoints it joins.
#[derive(Clone, Copy, Default)]
struct Last {
    edge: u32,
    /// The coarse face that it is the middle of, or the tet that it is inside.
    place: u32,
    /// Its number among the inner faces of the tet, or [`MIDDLE`].
    index: u8,
    /// The three edges by their local numbers in the tet.
    local: [u8; 3],
}

const MIDDLE: u8 = u8::MAX;

/// The faces whose first edge is the inner edge between the midpoints of the
/// coarse edges p < q; at most the middle of a coarse face and two faces in
/// each of its tets.
#[inline]
fn for_each_last(parents: &Parents, [p, q]: [u32; 2], from: Inner, mut each: impl FnMut(Last)) {
    match from {
        Inner::Cut { face, corner } => {
            if corner == 0 {
                let edge = parents.topology.face_edges[face as usize][2];
                each(Last { edge, place: face, index: MIDDLE, ..Last::default() });
            }
            for tet in parents.topology.face_tets[face as usize] {
                if tet != NONE {
                    beside_cut(&parents.parent(tet as usize), [p, q], &mut each);
                }
            }
        }
        Inner::Diagonal { tet } => {
            let parent = parents.parent(tet as usize);
            let [first, second] = MARKED;
            let local = if parent.edges[first] == p { [first, second] } else { [second, first] };
            for m in [0, 2, 3, 5] {
                inner_last(&parent, q, local, m, beside_diagonal(m), &mut each);
            }
        }
    }
}

/// The face that cuts off the corner, and that at the diagonal if one of the
/// edges is marked.
#[inline]
fn beside_cut(parent: &Parent, [p, q]: [u32; 2], each: &mut impl FnMut(Last)) {
    let (mut lp, mut lq) = (0, 0);
    for (local, &edge) in parent.edges.iter().enumerate() {
        lp = if edge == p { local } else { lp };
        lq = if edge == q { local } else { lq };
    }
    let between = BETWEEN[lp][lq];
    inner_last(parent, q, [lp, lq], between.third.into(), between.corner.into(), each);
    if MARKED.contains(&lp) {
        inner_last(parent, q, [lp, lq], 5 - lp, beside_diagonal(lq), each);
    } else if MARKED.contains(&lq) {
        inner_last(parent, q, [lp, lq], 5 - lq, beside_diagonal(lp), each);
    }
}

/// An inner face, if its third edge is the last.
#[inline]
fn inner_last(
    parent: &Parent,
    q: u32,
    [lp, lq]: [usize; 2],
    third: usize,
    index: usize,
    each: &mut impl FnMut(Last),
) {
    let edge = parent.edges[third];
    if edge > q {
        let local = [lp as u8, lq as u8, third as u8];
        each(Last { edge, place: parent.tet as u32, index: index as u8, local });
    }
}

/// A few faces, sorted as they come.
#[derive(Default)]
struct Lasts {
    list: [Last; 5],
    count: usize,
}

impl Lasts {
    fn insert(&mut self, last: Last) {
        let mut at = self.count;
        while at > 0 && self.list[at - 1].edge > last.edge {
            self.list[at] = self.list[at - 1];
            at -= 1;
        }
        self.list[at] = last;
        self.count += 1;
    }
}

/// Pieces of the arrays of faces: vertices, edges, tets.
type Pieces<'a> = (&'a mut [[u32; 3]], &'a mut [[u32; 3]], &'a mut [[u32; 2]]);

impl FineFaces {
    pub fn new(parents: &Parents, fine: &FineEdges, vertex_edges: &VertexEdges) -> Self {
        let coarse = parents.topology;
        let first_faces = first_faces(parents, fine, vertex_edges);
        let count = first_faces[fine.edges.len()] as usize;
        let mut made = Self {
            faces: zeroed(count),
            face_edges: zeroed(count),
            face_tets: zeroed(count),
            first_faces,
            parts: zeroed(coarse.faces.len()),
            middles: defaults(coarse.faces.len()),
            inner: defaults(parents.len()),
        };
        let firsts = &made.first_faces;
        let half_count = 2 * coarse.edges.len();
        let by_vertex: Vec<u32> =
            vertex_edges.offsets().iter().map(|&half| firsts[half as usize]).collect();
        let by_edge: Vec<u32> =
            fine.inner.firsts.iter().map(|&inner| firsts[half_count + inner as usize]).collect();
        let maker = Maker { parents, fine, middles: &made.middles, inner: &made.inner };
        let arrays = (&mut made.faces[..], &mut made.face_edges[..], &mut made.face_tets[..]);
        let corner_faces = by_vertex[by_vertex.len() - 1] as usize;
        let (corners, inner) = ragged::Cut::cut(arrays, corner_faces);
        ragged::for_each(&by_vertex, corners, |first, last, mut pieces| {
            let mut writer = Writer { at: 0, pieces: &mut pieces };
            (first..last).for_each(|v| maker.corner_faces(vertex_edges, v, &mut writer));
        });
        let base = corner_faces as u32;
        let by_edge: Vec<u32> = by_edge.into_iter().map(|first| first - base).collect();
        ragged::for_each(&by_edge, inner, |first, last, mut pieces| {
            let mut writer = Writer { at: 0, pieces: &mut pieces };
            (first..last)
                .for_each(|e| maker.inner_faces(e as u32, base + by_edge[first], &mut writer));
        });
        let each = made.parts.par_iter_mut().with_min_len(CHUNK).enumerate();
        each.for_each(|(face, parts)| *parts = corner_parts(parents, fine, firsts, face as u32));
        made
    }
}

/// Where the faces of each first fine edge begin.
fn first_faces(parents: &Parents, fine: &FineEdges, vertex_edges: &VertexEdges) -> Vec<u32> {
    let coarse = parents.topology;
    let mut firsts: Vec<u32> = zeroed(fine.edges.len() + 1);
    let (halves, inner) = firsts[1..].split_at_mut(2 * coarse.edges.len());
    ragged::for_each(vertex_edges.offsets(), halves, |first, last, counts| {
        let mut counts = counts.iter_mut();
        for v in first..last {
            for (&edge, count) in vertex_edges.of(v).iter().zip(&mut counts) {
                let ends_here = coarse.edges[edge as usize][1] == v as u32;
                let middle = if ends_here { fine.inner.edge_faces.middle(edge).len() } else { 0 };
                *count = (middle + coarse.faces_from(edge).len()) as u32;
            }
        }
    });
    ragged::for_each(&fine.inner.firsts, inner, |first, last, counts| {
        let mut counts = counts.iter_mut();
        for edge in first as u32..last as u32 {
            fine.inner.of(coarse, edge, |other, from| {
                let count = counts.next().expect("as many as counted");
                for_each_last(parents, [edge, other], from, |_| *count += 1);
            });
        }
    });
    ragged::accumulate(&mut firsts);
    firsts
}

/// The numbers of a coarse face's parts at its corners.
fn corner_parts(parents: &Parents, fine: &FineEdges, firsts: &[u32], face: u32) -> [u32; 3] {
    let coarse = parents.topology;
    let [ab, ac, _] = coarse.face_edges[face as usize];
    let place = face - coarse.first_faces[ab as usize];
    let rank = fine.inner.edge_faces.rank_in_middle(ac, face);
    let [at_a, at_b] = fine.halves[ab as usize].map(|half| firsts[half as usize]);
    let at_c = firsts[fine.halves[ac as usize][1] as usize];
    [at_a + place, at_b + fine.inner.edge_faces.middle(ab).len() as u32 + place, at_c + rank]
}

struct Writer<'a, 'b> {
    at: usize,
    pieces: &'a mut Pieces<'b>,
}

impl Writer<'_, '_> {
    fn push(&mut self, vertices: [u32; 3], edges: [u32; 3], tets: [u32; 2]) {
        let (all_vertices, all_edges, all_tets) = &mut *self.pieces;
        all_vertices[self.at] = vertices;
        all_edges[self.at] = edges;
        all_tets[self.at] = tets;
        self.at += 1;
    }
}

/// Makes the faces in order.
struct Maker<'a> {
    parents: &'a Parents<'a>,
    fine: &'a FineEdges<'a>,
    middles: &'a [AtomicU32],
    inner: &'a [[AtomicU32; INNER_FACES]],
}

impl Maker<'_> {
    /// The parts of coarse faces at a vertex v: (v, n + e, n + e') for each two
    /// edges e < e' of a face at v.
    fn corner_faces(&self, vertex_edges: &VertexEdges, v: usize, writer: &mut Writer) {
        let coarse = self.parents.topology;
        for &edge in vertex_edges.of(v) {
            let ends_here = coarse.edges[edge as usize][1] == v as u32;
            if ends_here {
                for &face in self.fine.inner.edge_faces.middle(edge) {
                    self.corner_face(face, 2, v as u32, writer);
                }
            }
            for face in coarse.faces_from(edge) {
                self.corner_face(face, usize::from(ends_here), v as u32, writer);
            }
        }
    }

    /// The part of a face at its corner a, b or c (0, 1, 2), which is vertex v.
    fn corner_face(&self, face: u32, corner: usize, v: u32, writer: &mut Writer) {
        let coarse = self.parents.topology;
        let n = coarse.vertex_count() as u32;
        let sides = coarse.face_edges[face as usize];
        // Its edges at the corner, and whether the corner is their higher end.
        const SIDES: [([usize; 2], [usize; 2]); 3] =
            [([0, 1], [0, 0]), ([0, 2], [1, 0]), ([1, 2], [1, 1])];
        let ([i, j], ends) = SIDES[corner];
        let [low, high] = [i, j].map(|side: usize| sides[side]);
        let halves = [low, high].map(|edge| self.fine.halves[edge as usize]);
        let edges = [halves[0][ends[0]], halves[1][ends[1]], self.fine.cuts[face as usize][corner]];
        let tets = self.children_on(face, |parent| place_of(v, parent.vertices));
        writer.push([v, n + low, n + high], edges, tets);
    }

    /// The faces between midpoints whose first edge belongs to coarse edge e;
    /// `base` is the number of the first face that the writer writes.
    fn inner_faces(&self, edge: u32, base: u32, writer: &mut Writer) {
        let coarse = self.parents.topology;
        let n = coarse.vertex_count() as u32;
        let half_count = 2 * coarse.edges.len() as u32;
        let mut number = half_count + self.fine.inner.firsts[edge as usize];
        self.fine.inner.of(coarse, edge, |other, from| {
            let mut lasts = Lasts::default();
            for_each_last(self.parents, [edge, other], from, |last| lasts.insert(last));
            for last in &lasts.list[..lasts.count] {
                let face = base + writer.at as u32;
                let vertices = [n + edge, n + other, n + last.edge];
                let (edges, tets) = if last.index == MIDDLE {
                    self.middles[last.place as usize].store(face, Relaxed);
                    self.middle_face(last.place)
                } else {
                    self.inner[last.place as usize][usize::from(last.index)].store(face, Relaxed);
                    self.inner_face(last)
                };
                writer.push(vertices, [number, edges[0], edges[1]], tets);
            }
            number += 1;
        });
    }

    /// The second and third edge of the middle of a face, and its tets.
    fn middle_face(&self, face: u32) -> ([u32; 2], [u32; 2]) {
        let [_, second, third] = self.fine.cuts[face as usize];
        let child = |parent: &Parent| MIDDLE_CHILD[place_of(face, parent.faces) as usize];
        ([second, third], self.children_on(face, child))
    }

    /// The tets on a part of a coarse face: of each tet there the child that is told.
    #[inline]
    fn children_on(&self, face: u32, child: impl Fn(&Parent) -> u32) -> [u32; 2] {
        let mut tets = self.parents.topology.face_tets[face as usize];
        for tet in tets.iter_mut().filter(|tet| **tet != NONE) {
            *tet = child_of(*tet, child(&self.parents.parent(*tet as usize)));
        }
        tets
    }

    /// The second and third edge of a face inside a tet, and its tets.
    fn inner_face(&self, last: &Last) -> ([u32; 2], [u32; 2]) {
        let parent = self.parents.parent(last.place as usize);
        let [p, q, r] = last.local;
        let second = self.fine.between(&parent, p.into(), r.into());
        let third = self.fine.between(&parent, q.into(), r.into());
        let children = INNER_CHILDREN[usize::from(last.index)];
        ([second, third], children.map(|child| child_of(last.place, child)))
    }
}

/// Where a number stands among four.
#[inline]
fn place_of(number: u32, four: &[u32; 4]) -> u32 {
    let mut place = 0;
    for (at, &other) in four.iter().enumerate() {
        place = if other == number { at as u32 } else { place };
    }
    place
}

impl FineEdges<'_> {
    /// The edge between the midpoints of two local edges of a tet.
    fn between(&self, parent: &Parent, p: usize, q: usize) -> u32 {
        let between = BETWEEN[p][q];
        let slot = usize::from(between.slot);
        if slot == DIAGONAL {
            return self.diagonals[parent.tet];
        }
        let face = (slot - CUTS) / 3;
        self.cuts[parent.faces[face] as usize][parent.rank(face, between.corner.into())]
    }
}
