//! What one step of the stage does.

use octruss_mesh::guard::usual_floor;
use octruss_mesh::{Features, Scheme, Step, TetMesh};

use super::keys::Subdivide;
use crate::options::MinQuality;

impl Subdivide {
    /// Parameters of a scheme other than the one chosen.
    pub(in crate::stages) fn contradiction(&self) -> Option<String> {
        let scheme = self.scheme.0;
        let wrong = |key: &str, owner: &str| {
            Some(format!("`{key}` belongs to {owner}, but `scheme` is `{}`", scheme.name()))
        };
        match (scheme, self.tension, self.interior) {
            (Scheme::Interpolatory { .. }, _, None) | (Scheme::LoopSolid { .. }, None, _) => None,
            (_, None, None) => None,
            (Scheme::Interpolatory { .. }, ..) | (_, None, Some(_)) => {
                wrong("interior", "`loop-solid`")
            }
            _ => wrong("tension", "`interpolatory` and `interpolatory-literal`"),
        }
    }

    /// The scheme with its parameters.
    pub(crate) fn scheme(&self) -> Scheme {
        match self.scheme.0 {
            Scheme::Interpolatory { tension, marked } => {
                Scheme::Interpolatory { tension: self.tension.map_or(tension, |w| w.0), marked }
            }
            Scheme::LoopSolid { interior } => {
                Scheme::LoopSolid { interior: self.interior.map_or(interior, |c| c.0) }
            }
            other => other,
        }
    }

    pub(super) fn step(&self, coarse: &TetMesh, is_last: bool) -> Step {
        let min_quality = match self.min_quality {
            // The linear rule is what the guard would pull back to.
            _ if self.scheme.0 == Scheme::Linear => None,
            Some(MinQuality::Off) => None,
            Some(MinQuality::Floor(eta)) => Some(eta),
            None => Some(usual_floor(coarse)),
        };
        Step {
            diagonal: self.diagonal.0,
            min_quality,
            interpolate: self.interpolates(coarse),
            project_limit: self.project_limit && is_last,
            curve_ends: self.curve_ends.map(|ends| ends.0),
            ..self.scheme().into()
        }
    }

    /// Whether the smooth surface is to pass through the vertices of a mesh: unless an
    /// approximating scheme moved these already.
    pub(super) fn interpolates(&self, mesh: &TetMesh) -> bool {
        let goes_on = |all: &Features| !all.smoothed || all.control_points.is_some();
        let usual = || mesh.features().is_none_or(goes_on);
        !self.scheme().keeps_vertices() && self.interpolate.unwrap_or_else(usual)
    }
}
