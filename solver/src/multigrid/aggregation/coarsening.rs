//! One step down from a level that has no coarser one given.

use crate::multigrid::aggregation::aggregates::Aggregates;
use crate::multigrid::aggregation::candidates::Candidates;
use crate::multigrid::aggregation::nodes::Nodes;
use crate::multigrid::aggregation::strength::StrongNeighbours;
use crate::multigrid::aggregation::tentative::Tentative;
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoothed_prolongation::smoothed;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;

/// θ on the first level; half of it on each next (Vaněk, Mandel and Brezina 1996, with a
/// smaller one than theirs: vertices of tets have some fourteen neighbours).
const THRESHOLD: f64 = 0.02;

/// A level that keeps more than this share of the rows is not worth its cost.
const STALLED: f64 = 0.7;

/// What the coarsest level so far hands to the one below it.
pub(crate) struct Coarsening<E> {
    nodes: Nodes,
    candidates: Candidates<E>,
    threshold: f64,
}

/// A level below: its prolongation and which of its directions are unknowns.
pub(crate) struct Coarsened<E: Entry> {
    pub(crate) prolongation: Csr<E>,
    pub(crate) projectors: Projectors<E>,
}

impl<E: Entry<Real = f64>> Coarsening<E> {
    /// From the near-null space of the coarsest given level.
    pub(crate) fn new(candidates: Candidates<E>, rows: usize) -> Self {
        Self { nodes: Nodes::single(rows), candidates, threshold: THRESHOLD }
    }

    /// The prolongation to a level's matrix from the next; none if that would hardly be
    /// smaller.
    pub(crate) fn step(
        &mut self,
        (matrix, diagonal): (&Csr<E>, &mut Diagonal<E>),
        fine: &Projectors<E>,
    ) -> Option<Coarsened<E>> {
        let strong = StrongNeighbours::new(matrix, &self.nodes, self.threshold);
        let aggregates = Aggregates::greedy(&strong, &self.nodes);
        let made = Tentative::new(&aggregates, &self.nodes, &self.candidates);
        let Tentative { prolongation, nodes, candidates, projectors } = made;
        if prolongation.columns() as f64 > STALLED * prolongation.rows() as f64 {
            return None;
        }
        let projectors = Projectors::trusted(nodes.row_count(), projectors);
        let prolongation = smoothed((matrix, diagonal), &prolongation, fine, |entry| entry);
        *self = Self { nodes, candidates, threshold: 0.5 * self.threshold };
        Some(Coarsened { prolongation, projectors })
    }
}
