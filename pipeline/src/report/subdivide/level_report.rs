//! One level of a refinement.

use octruss_mesh::Hierarchy;
use octruss_mesh::quality::mean_ratio_range;
use serde::{Deserialize, Serialize};

use crate::amount::short;

/// One level.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LevelReport {
    /// Vertices.
    pub vertices: usize,
    /// Tets.
    pub tets: usize,
    /// The worst mean ratio η of a tet: 1 regular, 0 flat.
    pub eta_min: f64,
    /// The mean of η.
    pub eta_mean: f64,
    /// What keeping the quality took, where it was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub guard: Option<GuardFigures>,
}

/// What keeping the quality took.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GuardFigures {
    /// The η that no tet falls below, unless its parent was below it.
    pub floor: f64,
    /// How many vertices were pulled back.
    pub pulled_back: usize,
    /// How many of them all the way to the linear rule.
    pub linear: usize,
}

impl LevelReport {
    /// The outcome in a few words.
    pub(crate) fn result(&self) -> String {
        let tets = short(self.tets);
        match &self.guard {
            // Rounding aside, only where linear refinement of the input falls below.
            Some(guard) if self.eta_min < guard.floor * (1.0 - 1e-6) => {
                let (eta, floor) = (self.eta_min, guard.floor);
                format!("{tets} tets, the worst η {eta:.2e} below {floor:.2e} as linear ones are")
            }
            Some(guard) if guard.pulled_back > 0 => {
                let (pulled, floor) = (short(guard.pulled_back), guard.floor);
                let floor =
                    if floor < 0.01 { format!("{floor:.1e}") } else { format!("{floor:.3}") };
                format!("{tets} tets, {pulled} vertices pulled back to keep η above {floor}")
            }
            _ => format!("{tets} tets"),
        }
    }

    pub(crate) fn of_finest(hierarchy: &Hierarchy) -> Self {
        let mesh = &hierarchy.finest().mesh;
        let (eta_min, eta_mean) = mean_ratio_range(mesh.raw());
        let guard = hierarchy.finest().refinement.as_ref().and_then(|refinement| refinement.guard);
        Self {
            vertices: mesh.points().len(),
            tets: mesh.tets().len(),
            eta_min,
            eta_mean,
            guard: guard.map(|guard| GuardFigures {
                floor: guard.floor,
                pulled_back: guard.pulled_back,
                linear: guard.linear,
            }),
        }
    }
}
