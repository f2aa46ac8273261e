//! Going round a vertex from triangle to triangle of one surface.

use rayon::prelude::*;

use crate::core::strata::Strata;
use crate::core::topology::{NONE, Topology};

/// One triangle met on the way through a sector.
pub(super) struct Step {
    /// Three times the triangle plus the place of the vertex in it.
    pub corner: u32,
    /// The neighbours by whose edges the way enters and leaves it.
    pub enters: u32,
    pub leaves: u32,
    pub reversed: bool,
}

/// The surface triangles, and which lie beside each other on one surface.
pub(super) struct Walk {
    pub triangles: Vec<[u32; 3]>,
    /// The triangle across the edge opposite each corner, or [`NONE`] across curves.
    across: Vec<[u32; 3]>,
}

impl Walk {
    pub fn new(topology: &Topology, strata: &Strata, on_surface: &[u32]) -> Self {
        let triangles = on_surface.iter().map(|&f| topology.faces()[f as usize]).collect();
        let mut sides: Vec<[u32; 2]> = Vec::with_capacity(3 * on_surface.len());
        for (t, &face) in (0u32..).zip(on_surface) {
            let [ab, ac, bc] = topology.face_edges()[face as usize];
            let opposite = [bc, ac, ab].into_iter().zip(3 * t..);
            let smooth = |edge: u32| strata.edge_dimensions[edge as usize] == 2;
            sides.extend(
                opposite.filter(|side| smooth(side.0)).map(|(edge, corner)| [edge, corner]),
            );
        }
        sides.par_sort_unstable();
        let mut across = vec![[NONE; 3]; on_surface.len()];
        for pair in sides.chunk_by(|a, b| a[0] == b[0]) {
            let &[[_, first], [_, second]] = pair else { continue };
            across[first as usize / 3][first as usize % 3] = second / 3;
            across[second as usize / 3][second as usize % 3] = first / 3;
        }
        Self { triangles, across }
    }

    /// The triangles round the vertex of a corner, up to the curves on either
    /// side or all round; whether it was all round.
    pub fn round(&self, corner: u32, steps: &mut Vec<Step>) -> bool {
        steps.clear();
        let slot = corner as usize % 3;
        let next = self.triangles[corner as usize / 3][(slot + 1) % 3];
        // Back to the first curve, then forward from there.
        let (start, enters) = self.last_from(corner, next);
        let mut at = start;
        let mut enters = enters.unwrap_or(next);
        loop {
            let step = self.step(at, enters);
            let leaves = step.leaves;
            let beyond = self.beyond(at, enters);
            steps.push(step);
            match beyond {
                Some(other) if other == start => return true,
                Some(other) => (at, enters) = (other, leaves),
                None => return false,
            }
        }
    }

    /// The last corner going backward from one that is entered from a
    /// neighbour, and the neighbour that leads into it from a curve, if any.
    fn last_from(&self, corner: u32, enters: u32) -> (u32, Option<u32>) {
        let (mut at, mut from) = (corner, enters);
        loop {
            // Backward the way leaves by the edge that it enters by forward.
            let other = self.step(at, from).leaves;
            match self.beyond(at, other) {
                None => return (at, Some(from)),
                Some(before) if before == corner => return (corner, None),
                Some(before) => {
                    from = self.step(before, from).leaves;
                    at = before;
                }
            }
        }
    }

    fn step(&self, corner: u32, enters: u32) -> Step {
        let (triangle, slot) = (&self.triangles[corner as usize / 3], corner as usize % 3);
        let [next, previous] = [triangle[(slot + 1) % 3], triangle[(slot + 2) % 3]];
        let reversed = enters != next;
        Step { corner, enters, leaves: if reversed { next } else { previous }, reversed }
    }

    /// The corner of the same vertex beyond the edge by which a way leaves that
    /// entered from a neighbour.
    fn beyond(&self, corner: u32, enters: u32) -> Option<u32> {
        let (t, slot) = (corner as usize / 3, corner as usize % 3);
        let entered = (0..3).find(|&s| self.triangles[t][s] == enters)?;
        let other = self.across[t][entered];
        if other == NONE {
            return None;
        }
        let vertex = self.triangles[t][slot];
        let place = self.triangles[other as usize].iter().position(|&v| v == vertex)?;
        Some(3 * other + place as u32)
    }
}
