//! What parts of tets are in the octet truss.
//!
//! A quarter of an octahedron stays one only together with the other three: if all
//! stay whole, or if all are split into eight along their marked diagonals. Else what
//! is left of the octahedron counts as tetrahedral cells, and so do parts of
//! bisected and quartered tets.

use rayon::prelude::*;

use crate::adapt::pattern::Pattern;
use crate::adapt::tets::Tets;
use crate::core::raw_mesh::Features;
use crate::core::reference_tet::CellState;
use crate::subdivide::step::Diagonal;
use octruss_base::ragged::CHUNK;

/// The states of all parts, in their order; empty if all are tetrahedral cells.
pub(super) fn states_of_parts(tets: &Tets, features: &Features) -> Vec<CellState> {
    let each = (0..tets.tets.len()).into_par_iter().with_min_len(CHUNK);
    let patterns: Vec<Pattern> = each.map(|tet| tets.pattern(tet)).collect();
    let splits_truss = tets.diagonal == Diagonal::Inherit;
    if features.cell_states.is_empty() && !(splits_truss && patterns.contains(&Pattern::Red)) {
        return Vec::new();
    }
    let whole = Octahedra::new(tets, &features.cell_states, &patterns);
    let mut states = Vec::new();
    for (tet, pattern) in patterns.into_iter().enumerate() {
        match pattern {
            Pattern::Whole => states.push(whole.state(tet)),
            Pattern::Red if splits_truss => states.extend(whole.state(tet).children()),
            _ => states.resize(states.len() + tets.count(tet), CellState::Tetrahedron),
        }
    }
    states
}

/// Which octahedra go through the split in one way.
struct Octahedra<'a> {
    tets: &'a Tets<'a>,
    states: &'a [CellState],
    /// For each edge that is the diagonal of one the ways that its quarters go.
    ways: Vec<u8>,
}

const STAYS: u8 = 1;
const IS_RED: u8 = 2;
const OTHER: u8 = 4;

impl<'a> Octahedra<'a> {
    fn new(tets: &'a Tets, states: &'a [CellState], patterns: &[Pattern]) -> Self {
        let mut octahedra = Self { tets, states, ways: vec![0; tets.topology.edges().len()] };
        for (tet, pattern) in patterns.iter().enumerate() {
            if let Some(edge) = octahedra.diagonal(tet) {
                octahedra.ways[edge as usize] |= match pattern {
                    Pattern::Whole => STAYS,
                    Pattern::Red if tets.diagonal == Diagonal::Inherit => IS_RED,
                    _ => OTHER,
                };
            }
        }
        octahedra
    }

    /// The edge that is the diagonal of the octahedron that a tet is a quarter of.
    fn diagonal(&self, tet: usize) -> Option<u32> {
        let local = self.states.get(tet)?.diagonal()?;
        Some(self.tets.topology.tet_edges()[tet][local])
    }

    /// The state of a tet, if what it is a part of stays together.
    fn state(&self, tet: usize) -> CellState {
        match self.diagonal(tet).map(|edge| self.ways[edge as usize]) {
            Some(STAYS | IS_RED) => self.states[tet],
            _ => CellState::Tetrahedron,
        }
    }
}
