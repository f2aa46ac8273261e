//! The tets round each edge.

use super::edges_and_faces::Topology;
use octruss_base::groups::Groups;

/// The tets round each edge, as slots 6 · tet + local edge, ascending.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EdgeTets(Groups<u32>);

impl EdgeTets {
    /// Lists the tets round every edge.
    pub fn new(topology: &Topology) -> Self {
        let tet_edges = topology.tet_edges();
        let slots = |t: usize| {
            let slot = |e| (tet_edges[t][e], (6 * t + e) as u32);
            std::array::from_fn::<_, 6, _>(slot)
        };
        Self(Groups::new(topology.edges().len(), tet_edges.len(), slots))
    }

    /// The slots 6 · tet + local edge round one edge, ascending.
    pub fn of(&self, edge: usize) -> &[u32] {
        self.0.of(edge)
    }
}
