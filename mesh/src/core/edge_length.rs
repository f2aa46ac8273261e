//! How long a mesh's edges are.

use rayon::prelude::*;

use crate::core::topology::Topology;
use octruss_base::ragged::CHUNK;
use octruss_base::vector3::{length, subtract};

/// The mean length of the edges between these points, in mesh units.
pub fn mean_edge_length(points: &[[f64; 3]], topology: &Topology) -> f64 {
    let edge_length = |&[a, b]: &[u32; 2]| {
        let [p, q] = [a, b].map(|v| points[v as usize]);
        length(subtract(p, q))
    };
    // By chunks, so that the sum does not depend on the number of threads.
    let edges = topology.edges();
    let sums: Vec<f64> =
        edges.par_chunks(CHUNK).map(|chunk| chunk.iter().map(edge_length).sum()).collect();
    sums.iter().sum::<f64>() / edges.len() as f64
}
