//! Aggregates: nodes in groups of a node and its strong neighbours.

use crate::multigrid::aggregation::nodes::Nodes;
use crate::multigrid::aggregation::strength::StrongNeighbours;
use octruss_base::groups::Groups;

/// The nodes of a level in groups, each of which becomes a node of the next.
pub(crate) struct Aggregates {
    of_node: Vec<u32>,
    count: usize,
}

const NONE: u32 = u32::MAX;

impl Aggregates {
    /// Greedy, in the order of nodes, so the same for any number of threads: first every
    /// node none of whose neighbours is taken, with all of them; then the others join the
    /// aggregate of most of their neighbours, the first of equals; what has none is
    /// grouped among itself. A node of one row without strong neighbours stays out, since
    /// smoothing alone solves for it; one of several is an aggregate of its own.
    pub(crate) fn greedy(strong: &StrongNeighbours, nodes: &Nodes) -> Self {
        let mut made = Self { of_node: vec![NONE; strong.nodes()], count: 0 };
        for node in 0..strong.nodes() {
            let is_free = |other: &u32| made.of_node[*other as usize] == NONE;
            let neighbours = strong.of(node);
            let counts = !neighbours.is_empty() || nodes.rows(node).len() > 1;
            if counts && is_free(&(node as u32)) && neighbours.iter().all(is_free) {
                made.group(node, neighbours);
            }
        }
        let roots_alone = made.of_node.clone();
        for node in (0..strong.nodes()).filter(|node| roots_alone[*node] == NONE) {
            let near = strong.of(node).iter().map(|other| roots_alone[*other as usize]);
            if let Some(aggregate) = most_frequent(near.filter(|a| *a != NONE).collect()) {
                made.of_node[node] = aggregate;
            }
        }
        for node in 0..strong.nodes() {
            if made.of_node[node] == NONE && !strong.of(node).is_empty() {
                made.group(node, strong.of(node));
            }
        }
        made
    }

    /// A new aggregate of a node and those of its neighbours that have none.
    fn group(&mut self, node: usize, neighbours: &[u32]) {
        let aggregate = self.count as u32;
        self.count += 1;
        self.of_node[node] = aggregate;
        for &other in neighbours {
            let slot = &mut self.of_node[other as usize];
            if *slot == NONE {
                *slot = aggregate;
            }
        }
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// The aggregate of a node, if it has one.
    pub(crate) fn of(&self, node: usize) -> Option<usize> {
        Some(self.of_node[node]).filter(|a| *a != NONE).map(|a| a as usize)
    }

    /// The nodes of each, ascending.
    pub(crate) fn members(&self) -> Groups<u32> {
        Groups::new(self.count, self.of_node.len(), |node| {
            self.of(node).map(|aggregate| (aggregate as u32, node as u32)).into_iter()
        })
    }
}

/// The first of the most frequent.
fn most_frequent(mut numbers: Vec<u32>) -> Option<u32> {
    numbers.sort_unstable();
    let longest = |a: &'_ [u32], b: &'_ [u32]| b.len() > a.len();
    let mut best: &[u32] = &[];
    for same in numbers.chunk_by(|a, b| a == b) {
        if longest(best, same) {
            best = same;
        }
    }
    best.first().copied()
}
