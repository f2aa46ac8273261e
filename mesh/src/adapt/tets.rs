//! The parts of each tet.

use crate::adapt::bisection::bisected;
use crate::adapt::midpoints::Midpoints;
use crate::adapt::parts::Parts;
use crate::adapt::pattern::Pattern;
use crate::adapt::quarters::quartered;
use crate::core::reference_tet::{
    CHILDREN, EDGES, FACES, MARKING_PERMUTATIONS, corners, edge_between,
};
use crate::core::topology::Topology;
use crate::marking::shortest_pair;
use crate::subdivide::step::Diagonal;

/// The tets of a mesh, about to be split.
pub(super) struct Tets<'a> {
    pub tets: &'a [[u32; 4]],
    pub topology: &'a Topology,
    pub midpoints: &'a Midpoints<'a>,
    pub diagonal: Diagonal,
    /// The points of the fine mesh, which begin with those of the coarse one.
    pub points: &'a [[f64; 3]],
}

impl Tets<'_> {
    /// How a tet is split.
    pub fn pattern(&self, tet: usize) -> Pattern {
        let bit = |(local, &edge): (usize, &u32)| u8::from(self.midpoints.is_split(edge)) << local;
        Pattern::of(self.topology.tet_edges()[tet].iter().enumerate().map(bit).sum())
    }

    /// How many parts a tet has.
    pub fn count(&self, tet: usize) -> usize {
        match self.pattern(tet) {
            Pattern::Whole => 1,
            Pattern::Bisections => self.bisections(tet).len(),
            Pattern::Quarters(_) => 4,
            Pattern::Red => CHILDREN.len(),
        }
    }

    /// The parts of a tet, all oriented as it. Those of the red split inherit the
    /// marking, those of other splits mark their shortest pair.
    pub fn parts(&self, tet: usize) -> Parts<4> {
        let mut parts = match self.pattern(tet) {
            Pattern::Whole => return Parts::from_iter([self.tets[tet]]),
            Pattern::Red => return self.children(tet),
            Pattern::Bisections => self.bisections(tet),
            Pattern::Quarters(apex) => {
                quartered(self.tets[tet], FACES[apex], |a, b| self.midpoint(tet, [a, b]))
            }
        };
        parts.iter_mut().for_each(|part| {
            let pair = shortest_pair(corners(self.points, *part));
            *part = MARKING_PERMUTATIONS[usize::from(pair)].map(|v| part[v]);
        });
        parts
    }

    fn bisections(&self, tet: usize) -> Parts<4> {
        bisected(self.tets[tet], &self.midpoints.cuts(self.topology.tet_edges()[tet]))
    }

    /// The eight children of the red split.
    fn children(&self, tet: usize) -> Parts<4> {
        let pair = match self.diagonal {
            Diagonal::Inherit => 0,
            Diagonal::ShortestEachLevel => shortest_pair(corners(self.points, self.tets[tet])),
        };
        let order = MARKING_PERMUTATIONS[usize::from(pair)];
        let edges = self.topology.tet_edges()[tet];
        let node = |n: usize| match n.checked_sub(4) {
            None => self.tets[tet][order[n]],
            Some(edge) => {
                let [a, b] = EDGES[edge];
                self.midpoints.of_edge(edges[edge_between(order[a], order[b])])
            }
        };
        CHILDREN.map(|child| child.map(node)).into_iter().collect()
    }

    /// The vertex in the middle of an edge of a tet.
    fn midpoint(&self, tet: usize, ends: [u32; 2]) -> u32 {
        let vertices = self.tets[tet];
        let place = |v: u32| vertices.iter().position(|&own| own == v).expect("its own vertex");
        let edge = edge_between(place(ends[0]), place(ends[1]));
        self.midpoints.of_edge(self.topology.tet_edges()[tet][edge])
    }
}
