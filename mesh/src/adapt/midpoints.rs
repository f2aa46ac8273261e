//! The vertices that split edges get, and the order of cuts.

use crate::adapt::bisection::{Cut, Cuts};
use crate::adapt::marked_edges::MarkedEdges;
use crate::core::topology::{NONE, Topology};
use octruss_base::vector3::{dot3, subtract};

/// The midpoints of the edges that are split.
pub(super) struct Midpoints<'a> {
    points: &'a [[f64; 3]],
    topology: &'a Topology,
    /// The vertex of each edge, or [`NONE`] of one that stays.
    of_edges: Vec<u32>,
}

impl<'a> Midpoints<'a> {
    /// Vertices in edge order after those of the mesh.
    pub fn new(points: &'a [[f64; 3]], topology: &'a Topology, split: &MarkedEdges) -> Self {
        let mut next = topology.vertex_count() as u32;
        let of_edge = |&is_split: &bool| {
            let own = if is_split { next } else { NONE };
            next += u32::from(is_split);
            own
        };
        let of_edges = split.as_list().iter().map(of_edge).collect();
        Self { points, topology, of_edges }
    }

    /// Whether an edge is split.
    #[inline]
    pub fn is_split(&self, edge: u32) -> bool {
        self.of_edges[edge as usize] != NONE
    }

    /// The vertex of an edge that is split.
    #[inline]
    pub fn of_edge(&self, edge: u32) -> u32 {
        self.of_edges[edge as usize]
    }

    /// The vertex between two vertices whose edge is split.
    ///
    /// # Panics
    /// If they have no edge.
    pub fn between(&self, a: u32, b: u32) -> u32 {
        self.of_edge(self.topology.edge_between(a, b).expect("simplices have their edges"))
    }

    /// The cuts among some edges, in the order of the mesh.
    pub fn cuts(&self, edges: impl IntoIterator<Item = u32>) -> Cuts {
        let split = edges.into_iter().filter(|&edge| self.is_split(edge));
        let mut cuts: Cuts = split.map(|edge| self.cut(edge)).collect();
        cuts.sort_unstable_by(Cut::order);
        cuts
    }

    fn cut(&self, edge: u32) -> Cut {
        let ends = self.topology.edges()[edge as usize];
        let [p, q] = ends.map(|end| self.points[end as usize]);
        let along = subtract(p, q);
        Cut { ends, midpoint: self.of_edge(edge), length: dot3(along, along) }
    }
}
