//! Choosing pairs so that neighbours agree across their faces.

use super::breadth_first::neighbours;
use crate::core::reference_tet::edge_in_face;
use crate::core::topology::{NONE, Topology};

/// Stands for a pair that is not chosen yet.
const UNMARKED: u8 = 3;

/// Sweeps of the local search; more of them gain little.
const MAX_SWEEPS: usize = 10;

/// The pairs that a tet may mark.
pub(super) struct Preference {
    /// All three pairs, the preferred one first.
    order: [u8; 3],
    /// How many of them, from the front, are allowed.
    allowed: u8,
}

impl Preference {
    /// Only the pairs that no other beats.
    pub fn shortest(ranks: [u8; 3]) -> Self {
        let allowed = ranks.iter().filter(|&&rank| rank == 0).count() as u8;
        Self { allowed, ..Self::any(ranks) }
    }

    /// All pairs, those of lower rank preferred.
    pub fn any(ranks: [u8; 3]) -> Self {
        let mut order = [0, 1, 2];
        order.sort_by_key(|&pair| ranks[usize::from(pair)]);
        Self { order, allowed: 3 }
    }

    fn pairs(&self) -> &[u8] {
        &self.order[..usize::from(self.allowed)]
    }
}

/// The pairs chosen so far.
pub(super) struct Marks<'a> {
    topology: &'a Topology,
    preferences: Vec<Preference>,
    pairs: Vec<u8>,
}

impl<'a> Marks<'a> {
    /// Marks the tets that have no choice, no others yet.
    pub fn new(topology: &'a Topology, preferences: Vec<Preference>) -> Self {
        let mut marks = Self { topology, pairs: vec![UNMARKED; preferences.len()], preferences };
        (0..marks.pairs.len()).for_each(|tet| marks.unmark(tet));
        marks
    }

    pub fn into_pairs(self) -> Vec<u8> {
        self.pairs
    }

    fn unmark(&mut self, tet: usize) {
        self.pairs[tet] = match self.preferences[tet].pairs() {
            &[only] => only,
            _ => UNMARKED,
        };
    }

    /// Marks the tets of a part in turn, the first with one of its choices, the
    /// others in agreement with most neighbours marked before.
    pub fn spread(&mut self, part: &[u32], root_choice: usize) {
        let root = part[0] as usize;
        self.pairs[root] = self.preferences[root].pairs()[root_choice];
        for &tet in &part[1..] {
            let tet = tet as usize;
            if self.pairs[tet] == UNMARKED
                && let Some((pair, _)) = self.best_pair(tet, |_| true)
            {
                self.pairs[tet] = pair;
            }
        }
    }

    /// Spreads from each choice that the first tet has; the one with fewest
    /// conflicts stays. Each pair has its own edge in a face, so only one agrees
    /// with a given neighbour: where a marking without conflicts is possible,
    /// one of these finds it.
    pub fn spread_from_best_root(&mut self, part: &[u32]) {
        let mut best: Option<(usize, Vec<u8>)> = None;
        for choice in 0..self.preferences[part[0] as usize].pairs().len() {
            part.iter().for_each(|&tet| self.unmark(tet as usize));
            self.spread(part, choice);
            let conflicts = self.conflicts(part);
            if best.as_ref().is_none_or(|&(fewest, _)| conflicts < fewest) {
                best =
                    Some((conflicts, part.iter().map(|&tet| self.pairs[tet as usize]).collect()));
            }
            if conflicts == 0 {
                break;
            }
        }
        let (_, pairs) = best.expect("a tet may mark at least one pair");
        for (&tet, pair) in part.iter().zip(pairs) {
            self.pairs[tet as usize] = pair;
        }
    }

    /// Local search: sweeps over the tets that conflict with a neighbour, each
    /// changing to the best of its other pairs if that agrees with no fewer.
    /// So the conflicts never become more, but move until some meet and vanish.
    pub fn improve(&mut self) {
        for _ in 0..MAX_SWEEPS {
            let mut changed = false;
            for tet in 0..self.pairs.len() {
                let own = self.pairs[tet];
                let agreements = self.agreements(tet, own);
                if agreements == self.neighbour_count(tet) {
                    continue;
                }
                if let Some((pair, others)) = self.best_pair(tet, |pair| pair != own)
                    && others >= agreements
                {
                    self.pairs[tet] = pair;
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
    }

    /// Of the allowed pairs that qualify the one with most agreements, and how
    /// many; the preferred one of equals.
    fn best_pair(&self, tet: usize, qualifies: impl Fn(u8) -> bool) -> Option<(u8, usize)> {
        let pairs = self.preferences[tet].pairs().iter().filter(|&&pair| qualifies(pair));
        let scored = pairs.map(|&pair| (pair, self.agreements(tet, pair)));
        // Of equals `max_by_key` takes the last.
        scored.rev().max_by_key(|&(_, agreements)| agreements)
    }

    fn neighbour_count(&self, tet: usize) -> usize {
        neighbours(self.topology, tet).iter().filter(|&&neighbour| neighbour != NONE).count()
    }

    /// How many marked neighbours agree with a tet if it marks this pair.
    fn agreements(&self, tet: usize, pair: u8) -> usize {
        let across = neighbours(self.topology, tet);
        (0..4)
            .filter(|&face| {
                let neighbour = across[face];
                neighbour != NONE
                    && self.edge_marked_by(neighbour as usize, self.topology.tet_faces()[tet][face])
                        == Some(self.marked_edge(tet, face, pair))
            })
            .count()
    }

    /// Twice the number of conflicting faces in a part whose tets are all marked.
    fn conflicts(&self, part: &[u32]) -> usize {
        let conflicts = |&tet: &u32| {
            let tet = tet as usize;
            self.neighbour_count(tet) - self.agreements(tet, self.pairs[tet])
        };
        part.iter().map(conflicts).sum()
    }

    fn edge_marked_by(&self, tet: usize, face: u32) -> Option<u32> {
        let local = self.topology.tet_faces()[tet].iter().position(|&own| own == face)?;
        (self.pairs[tet] != UNMARKED).then(|| self.marked_edge(tet, local, self.pairs[tet]))
    }

    fn marked_edge(&self, tet: usize, face: usize, pair: u8) -> u32 {
        self.topology.tet_edges()[tet][edge_in_face(usize::from(pair), face)]
    }
}
