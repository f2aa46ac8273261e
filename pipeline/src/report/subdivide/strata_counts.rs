//! What stays sharp, and why.

use std::collections::BTreeMap;

use octruss_mesh::{FeatureReasons, Hierarchy, Reason, Strata};
use serde::{Deserialize, Serialize};

/// How much of the coarsest level is below the solid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StrataCounts {
    /// Edges that are curves.
    pub crease_edges: usize,
    /// Vertices that were made corners; ends and crossings of curves stay, too,
    /// without being counted.
    pub corners: usize,
    /// Faces of surfaces: the boundary, interfaces and the groups asked for.
    pub surface_faces: usize,
    /// Why edges are curves: how many for each [`Reason`]. Of the first stage that
    /// subdivides only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve_reasons: Option<ReasonCounts>,
    /// Why vertices are fixed, also those where curves end or cross.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point_reasons: Option<ReasonCounts>,
}

/// How many parts of the mesh each reason holds for, by its name; reasons
/// that hold nowhere are listed, too.
pub type ReasonCounts = BTreeMap<String, usize>;

impl StrataCounts {
    pub(crate) fn of_finest(hierarchy: &Hierarchy, reasons: Option<&FeatureReasons>) -> Self {
        let mesh = &hierarchy.finest().mesh;
        let topology = &hierarchy.finest().topology;
        let features = mesh.features().cloned().unwrap_or_default();
        let strata = Strata::new(mesh.raw(), topology, &features);
        Self {
            crease_edges: features.creases.len(),
            corners: features.corners.len(),
            surface_faces: strata.is_surface.iter().filter(|is| **is).count(),
            curve_reasons: reasons.map(|reasons| count(&Reason::OF_CURVES, &reasons.curves)),
            point_reasons: reasons.map(|reasons| count(&Reason::OF_POINTS, &reasons.points)),
        }
    }
}

fn count<T>(listed: &[Reason], parts: &[(T, Reason)]) -> ReasonCounts {
    let mut counts: ReasonCounts = listed.iter().map(|reason| (reason.name().into(), 0)).collect();
    parts.iter().for_each(|(_, reason)| *counts.entry(reason.name().into()).or_default() += 1);
    counts
}
