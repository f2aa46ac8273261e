//! How a coarsest mesh is readied.

use crate::features::extra::ExtraFeatures;
use crate::features::group_borders::GroupBorders;
use crate::features::mirrors::Mirrors;
use crate::marking::Marking;

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
    /// Which edges between faces of different surface groups are creases whatever
    /// their angle.
    pub group_borders: GroupBorders,
    /// Surface groups that are surface strata even inside a region.
    pub surfaces: Vec<i32>,
    /// Surface groups that are mirror planes.
    pub mirrors: Mirrors,
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
            group_borders: GroupBorders::default(),
            surfaces: Vec::new(),
            mirrors: Mirrors::default(),
            extra: ExtraFeatures::default(),
        }
    }
}
