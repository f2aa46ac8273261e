//! The surfaces of a mesh cut along their curves: the sectors of each vertex.

use rayon::prelude::*;

use super::error::LimitError;
use crate::core::strata::Strata;
use crate::core::topology::{NONE, Topology};

/// The triangles of one surface at one vertex between its curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sector {
    pub vertex: u32,
    /// The neighbours on the curve that the vertex follows; [`NONE`] twice where
    /// it follows none.
    pub along: [u32; 2],
    /// Whether the vertex stays where it is.
    pub fixed: bool,
    /// Whether the sector goes all round.
    pub closed: bool,
    /// The face with which it begins, and whether it runs against that face's
    /// order of corners; whether that order is clockwise seen from where the
    /// normal points to.
    pub face: u32,
    pub reversed: bool,
    pub flipped: bool,
    /// Whether the vertex is smooth but its triangles make more than one disc.
    pub touches: bool,
    /// Whether the regular lattice has the same rules: a smooth vertex of
    /// valence six, or a curve vertex with three triangles, whose missing
    /// neighbours are mirrored (Wang's Equation 5.1).
    pub regular: bool,
}

/// A corner of a triangle: its place in the sector that holds it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct CornerPlace {
    pub sector: u32,
    /// The place of the neighbour with which the triangle begins.
    pub at: u32,
    /// Whether the sector runs against the triangle's order of corners.
    pub reversed: bool,
}

/// All sectors, by vertex.
#[derive(Debug, Clone)]
pub(super) struct Sectors {
    pub sectors: Vec<Sector>,
    /// Where the neighbours of each sector start; one more than sectors.
    offsets: Vec<u32>,
    neighbours: Vec<u32>,
    /// For each face its number among those of surfaces, or [`NONE`].
    number_of: Vec<u32>,
    /// The corners of the surface triangles.
    corners: Vec<[CornerPlace; 3]>,
    /// Whether each of them is clockwise seen from where its normal points to.
    flipped: Vec<bool>,
}

impl Sectors {
    pub fn neighbours(&self, sector: usize) -> &[u32] {
        &self.neighbours[self.offsets[sector] as usize..self.offsets[sector + 1] as usize]
    }

    /// The corners of a face.
    ///
    /// # Errors
    /// If there is no such face, or it is on no surface.
    pub fn corners(&self, face: u32) -> Result<&[CornerPlace; 3], LimitError> {
        let Some(&number) = self.number_of.get(face as usize) else {
            return Err(LimitError::NoFace { face, faces: self.number_of.len() });
        };
        self.corners.get(number as usize).ok_or(LimitError::NotOnSurface { face })
    }

    /// Whether a face of a surface is clockwise seen from where its normal points
    /// to.
    pub fn is_flipped(&self, face: u32) -> bool {
        self.flipped[self.number_of[face as usize] as usize]
    }

    /// The sectors of all surfaces; `is_flipped` tells whether a face is
    /// clockwise seen from the side that its normal points to.
    pub fn new(
        topology: &Topology,
        strata: &Strata,
        is_flipped: impl Fn(u32) -> bool + Sync,
    ) -> Self {
        let mut number_of = vec![NONE; topology.faces().len()];
        let on_surface: Vec<u32> =
            (0..number_of.len() as u32).filter(|&f| strata.is_surface[f as usize]).collect();
        (0u32..).zip(&on_surface).for_each(|(t, &face)| number_of[face as usize] = t);
        let walk = Walk::new(topology, strata, &on_surface);
        let mut by_vertex: Vec<[u32; 2]> = (0u32..)
            .zip(&walk.triangles)
            .flat_map(|(t, v)| [0, 1, 2].map(|s| [v[s], 3 * t + s as u32]))
            .collect();
        by_vertex.par_sort_unstable();
        let unset = CornerPlace { sector: NONE, ..CornerPlace::default() };
        let mut all = Self {
            sectors: Vec::new(),
            offsets: vec![0],
            neighbours: Vec::new(),
            number_of,
            corners: vec![[unset; 3]; on_surface.len()],
            flipped: on_surface.par_iter().map(|&face| is_flipped(face)).collect(),
        };
        let mut steps = Vec::new();
        for [vertex, corner] in by_vertex {
            if all.corners[corner as usize / 3][corner as usize % 3].sector == NONE {
                let closed = walk.round(corner, &mut steps);
                let face = on_surface[steps[0].corner as usize / 3];
                all.push([vertex, face], &steps, closed);
                all.follow(strata);
            }
        }
        all
    }

    /// Takes in a sector from the corners that were met going through it.
    fn push(&mut self, [vertex, face]: [u32; 2], steps: &[Step], closed: bool) {
        let sector = self.sectors.len() as u32;
        for (at, step) in (0u32..).zip(steps) {
            let (triangle, slot) = (step.corner as usize / 3, step.corner as usize % 3);
            self.corners[triangle][slot] = CornerPlace { sector, at, reversed: step.reversed };
            self.neighbours.push(step.enters);
        }
        if !closed {
            self.neighbours.extend(steps.last().map(|step| step.leaves));
        }
        self.offsets.push(self.neighbours.len() as u32);
        self.sectors.push(Sector {
            vertex,
            along: [NONE; 2],
            fixed: false,
            closed,
            face,
            reversed: steps[0].reversed,
            flipped: self.flipped[steps[0].corner as usize / 3],
            touches: false,
            regular: false,
        });
    }

    /// Which rule the vertex of the last sector follows.
    fn follow(&mut self, strata: &Strata) {
        let last = self.sectors.len() - 1;
        let ring = &self.neighbours[self.offsets[last] as usize..];
        let (first, end) = (ring[0], ring[ring.len() - 1]);
        let sector = &mut self.sectors[last];
        let vertex = sector.vertex;
        match (strata.vertex_dimensions[vertex as usize], strata.curve_neighbours(vertex)) {
            (1, &[p, q]) => {
                sector.along = [p, q];
                let is_border = [first, end] == [p, q] || [first, end] == [q, p];
                sector.regular = is_border && !sector.closed && ring.len() == 4;
            }
            (0 | 1, _) => sector.fixed = true,
            _ => {
                let is_dart = !sector.closed && first == end;
                let met = ring.len() - usize::from(is_dart);
                let is_all = met == strata.surface_neighbours(vertex).len();
                sector.touches = met < 3 || !is_all || !(sector.closed || is_dart);
                sector.regular = sector.closed && met == 6 && !sector.touches;
            }
        }
    }
}

/// One triangle met on the way through a sector.
struct Step {
    /// Three times the triangle plus the place of the vertex in it.
    corner: u32,
    /// The neighbours by whose edges the way enters and leaves it.
    enters: u32,
    leaves: u32,
    reversed: bool,
}

/// The surface triangles, and which lie beside each other on one surface.
struct Walk {
    triangles: Vec<[u32; 3]>,
    /// The triangle across the edge opposite each corner, or [`NONE`] across curves.
    across: Vec<[u32; 3]>,
}

impl Walk {
    fn new(topology: &Topology, strata: &Strata, on_surface: &[u32]) -> Self {
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
    fn round(&self, corner: u32, steps: &mut Vec<Step>) -> bool {
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
