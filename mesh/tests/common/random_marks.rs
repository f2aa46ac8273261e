//! Random marks on edges, of every kind and density.

use octruss_mesh::{MarkedEdges, Topology};

use super::random_block::Random;

/// Marks some edges, or the edges of some faces, tets or vertices; few or many.
pub fn random_marks(topology: &Topology, seed: u64) -> MarkedEdges {
    let mut random = Random::new(seed);
    let mut marks = MarkedEdges::new(topology);
    let one_in = [2, 5, 20, 100][random.below(4)];
    let kind = random.below(5);
    let mut some = |count: usize| -> Vec<u32> {
        (0..count as u32).filter(|_| random.below(one_in) == 0).collect()
    };
    match kind {
        0 => marks.mark_faces(topology, some(topology.faces().len())),
        1 => marks.mark_tets(topology, some(topology.tet_edges().len())),
        2 => marks.mark_vertices(topology, some(topology.vertex_count())),
        _ => marks.mark_edges(some(topology.edges().len())),
    }
    marks
}
