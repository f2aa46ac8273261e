//! Readying the coarsest mesh, once: its marking, its creases and corners.

mod extra;
mod found;
mod reasons;

pub use extra::{ExtraFeatures, FeatureError};
pub use found::find_features;
pub use reasons::{FeatureReasons, Reason};

use crate::core::raw_mesh::Features;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::marking::{Marking, mark};
use crate::soundness::quality::smallest_mean_ratio;

/// How a coarsest mesh is readied: its marking, and where its creases and
/// corners come from.
#[derive(Debug, Clone, PartialEq)]
pub struct FeatureOptions {
    /// Which pair of opposite edges each tet marks.
    pub marking: Marking,
    /// An edge of two surface faces is a crease if the angle between their
    /// outward normals exceeds this, in degrees; 180 for none.
    pub crease_angle: f64,
    /// Tagged edges (curve groups) are creases.
    pub group_curves: bool,
    /// Tagged vertices (point groups) are corners.
    pub group_points: bool,
    /// Edges between faces of different surface groups are creases.
    pub group_borders: bool,
    /// Surface groups that are surface strata even inside a region.
    pub surfaces: Vec<i32>,
    /// Creases and corners that were asked for by their vertices, of the mesh
    /// that is readied.
    pub extra: ExtraFeatures,
}

impl Default for FeatureOptions {
    fn default() -> Self {
        Self {
            marking: Marking::default(),
            crease_angle: 40.0,
            group_curves: true,
            group_points: true,
            group_borders: true,
            surfaces: Vec::new(),
            extra: ExtraFeatures::default(),
        }
    }
}

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
