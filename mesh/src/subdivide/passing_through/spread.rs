//! How the solid follows its boundary.

use rayon::prelude::*;

use crate::core::mirrors::Unfolded;
use crate::core::topology::VertexEdges;
use octruss_base::ragged::CHUNK;
use octruss_base::vector3::{Vector3, add, scale};

/// Enough to even out what would flatten tets beside the boundary; displacements do not
/// get further than as many edges.
const SWEEPS: usize = 8;

/// Gives each of these vertices the mean displacement of its neighbours, some times over
/// (Jacobi's iteration); the others keep theirs.
/// There is one for each unfolded vertex; those of images are made by this.
pub(super) fn spread(mesh: &Unfolded, inner: &[u32], displacements: &mut [Vector3]) {
    let topology = &*mesh.topology;
    let incident = VertexEdges::new(topology);
    for _ in 0..SWEEPS {
        mesh.turn_images(displacements);
        let mean = |&v: &u32| {
            let edges = incident.of(v as usize);
            let ends = edges.iter().map(|&edge| topology.edges()[edge as usize]);
            let sum = ends.map(|[a, b]| displacements[(a ^ b ^ v) as usize]).fold([0.0; 3], add);
            scale((edges.len().max(1) as f64).recip(), sum)
        };
        let means: Vec<Vector3> = inner.par_iter().with_min_len(CHUNK).map(mean).collect();
        for (&vertex, mean) in inner.iter().zip(means) {
            displacements[vertex as usize] = mean;
        }
    }
}
