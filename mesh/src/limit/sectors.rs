//! The surfaces of a mesh cut along their curves: the sectors of each vertex.

use rayon::prelude::*;

use super::error::LimitError;
use super::walk::{Step, Walk};
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
