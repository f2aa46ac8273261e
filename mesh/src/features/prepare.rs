//! Readying the coarsest mesh, once.

use crate::core::raw_mesh::Features;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::features::found::find_features;
use crate::features::options::FeatureOptions;
use crate::marking::mark;
use crate::soundness::quality::smallest_mean_ratio;

/// Readies a coarsest mesh for refinement: marks its tets and finds its
/// features. A mesh that carries features has been through this and is
/// returned as it is, whatever the options, so that refining twice by one level
/// equals once by two.
pub fn prepare(mesh: TetMesh, options: &FeatureOptions) -> TetMesh {
    if mesh.features().is_some() {
        return mesh;
    }
    let mut raw = mesh.into_raw();
    let topology = Topology::new(&raw);
    mark(&mut raw, &topology, options.marking);
    let initial_quality = Some(smallest_mean_ratio(&raw));
    raw.features = Some(Features { initial_quality, ..find_features(&raw, &topology, options) });
    TetMesh::trusted(raw)
}
