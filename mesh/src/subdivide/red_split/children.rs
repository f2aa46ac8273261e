//! The fine tets with the numbers of their edges and faces.

use std::sync::atomic::Ordering::Relaxed;

use rayon::prelude::*;

use super::edges::FineEdges;
use super::faces::FineFaces;
use super::parents::{Parent, Parents, Ranks};
use super::parts::{PARTS, families_mut};
use super::slots::{
    CHILD_EDGES, CHILD_FACES, CHILD_NODES, CUTS, DIAGONAL, EDGE_SLOTS, FACE_SLOTS, INNER,
};
use crate::core::reference_tet::EDGES;
use octruss_base::large_array::zeroed;
use octruss_base::ragged::CHUNK;

/// The children of all tets, family after family.
pub(super) struct Children {
    pub tets: Vec<[u32; 4]>,
    pub edges: Vec<[u32; 6]>,
    pub faces: Vec<[u32; 4]>,
}

impl Children {
    pub fn new(parents: &Parents, edges: &FineEdges, faces: &FineFaces) -> Self {
        let count = PARTS * parents.len();
        let n = parents.topology.vertex_count() as u32;
        let mut made = Self { tets: zeroed(count), edges: zeroed(count), faces: zeroed(count) };
        let by_parent = families_mut(&mut made.tets).par_iter_mut();
        let by_parent = by_parent
            .zip(families_mut(&mut made.edges))
            .zip(families_mut(&mut made.faces))
            .with_min_len(CHUNK)
            .enumerate();
        by_parent.for_each(|(tet, ((tets, child_edges), child_faces))| {
            let parent = parents.parent(tet);
            let ranks = parent.ranks();
            let nodes = nodes(&parent, n);
            look_up(tets, &CHILD_NODES, &nodes);
            look_up(child_edges, &CHILD_EDGES, &edge_slots(&parent, &ranks, edges));
            look_up(child_faces, &CHILD_FACES, &face_slots(&parent, &ranks, faces));
        });
        made
    }
}

/// The numbers behind the slots of all children. (Plain loops, here and below:
/// nested maps of arrays are not inlined and cost several times as much.)
#[inline]
fn look_up<const N: usize, const SLOTS: usize>(
    children: &mut [[u32; N]; PARTS],
    table: &[[u8; N]; PARTS],
    numbers: &[u32; SLOTS],
) {
    for (child, slots) in children.iter_mut().zip(table) {
        for (number, &slot) in child.iter_mut().zip(slots) {
            *number = numbers[usize::from(slot)];
        }
    }
}

fn nodes(parent: &Parent, n: u32) -> [u32; 10] {
    let mut nodes = [0; 10];
    nodes[..4].copy_from_slice(parent.vertices);
    for (node, edge) in nodes[4..].iter_mut().zip(parent.edges) {
        *node = n + edge;
    }
    nodes
}

fn edge_slots(parent: &Parent, ranks: &Ranks, fine: &FineEdges) -> [u32; EDGE_SLOTS] {
    let mut slots = [0; EDGE_SLOTS];
    for (local, [a, b]) in EDGES.into_iter().enumerate() {
        let [low, high] = fine.halves[parent.edges[local] as usize];
        let ascends = parent.vertices[a] < parent.vertices[b];
        [slots[2 * local], slots[2 * local + 1]] = if ascends { [low, high] } else { [high, low] };
    }
    for (face, ranks) in ranks.iter().enumerate() {
        let cuts = fine.cuts[parent.faces[face] as usize];
        for (corner, &rank) in ranks.iter().enumerate() {
            slots[CUTS + 3 * face + corner] = cuts[usize::from(rank)];
        }
    }
    slots[DIAGONAL] = fine.diagonals[parent.tet];
    slots
}

fn face_slots(parent: &Parent, ranks: &Ranks, fine: &FineFaces) -> [u32; FACE_SLOTS] {
    let mut slots = [0; FACE_SLOTS];
    for (face, ranks) in ranks.iter().enumerate() {
        let number = parent.faces[face] as usize;
        let parts = fine.parts[number];
        for (corner, &rank) in ranks.iter().enumerate() {
            slots[4 * face + corner] = parts[usize::from(rank)];
        }
        slots[4 * face + 3] = fine.middles[number].load(Relaxed);
    }
    for (slot, inner) in slots[INNER..].iter_mut().zip(&fine.inner[parent.tet]) {
        *slot = inner.load(Relaxed);
    }
    slots
}
