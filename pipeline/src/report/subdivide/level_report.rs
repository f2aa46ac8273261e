//! One level of a refinement.

use octruss_base::chunks::map_ranges;
use octruss_mesh::quality::mean_ratio_range;
use octruss_mesh::{Hierarchy, InterpolationReport, LimitDistances, Placement, Step, TetMesh};
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
    /// The volume of all tets together, in cubic mesh units.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume: Option<f64>,
    /// How far boundary vertices are from the limit of further steps by the same scheme; of
    /// smooth schemes only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limit: Option<LimitFigures>,
    /// How passing through the vertices of the input went, if the smooth surface does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interpolation: Option<InterpolationFigures>,
    /// What keeping the quality took, where it was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub guard: Option<GuardFigures>,
}

/// How far boundary vertices are from the limit, in mesh units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LimitFigures {
    /// The largest distance of a vertex of the level.
    pub largest: f64,
    /// The mean over them.
    pub mean: f64,
    /// The largest distance of a vertex of the coarsest level, as it came in.
    pub input_largest: f64,
    /// The mean over these.
    pub input_mean: f64,
}

impl LimitFigures {
    /// Of the finest level, refined on by a step.
    pub(crate) fn of_finest(hierarchy: &Hierarchy, step: Step) -> Option<Self> {
        let distances = || {
            let all = hierarchy.limit_distances(hierarchy.transfers(), step);
            let LimitDistances { largest, mean, input_largest, input_mean } = all;
            Self { largest, mean, input_largest, input_mean }
        };
        (!step.scheme.keeps_vertices()).then(distances)
    }
}

/// How reports call [`Placement::AtLimit`].
pub(crate) const AT_LIMIT: &str = "at-limit";

/// How passing through the vertices of the input went.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InterpolationFigures {
    /// The iterations that solving for control points took, on curves and on surfaces; 0 if
    /// they came with the mesh.
    pub iterations: [usize; 2],
    /// How far, at most, the limit of a control point is from its vertex, in mesh units; 0 if
    /// they came with the mesh.
    pub residual: f64,
    /// Whether that is at most 1e-10 of an edge, as it was to be.
    pub has_converged: bool,
    /// How many rows of the matrix could not be made exact for the positions.
    pub inexact_rows: usize,
    /// `along-normals`; `at-limit` where walls are so thin that the former would turn tets
    /// inside out.
    pub placement: String,
    /// The largest distance, in mesh units, by which the guard pulled a boundary vertex from
    /// where the limit had put it.
    pub left_to_limit: f64,
    /// How many vertices have a neighbour whose control point is moved against theirs by more than
    /// the two are apart: there the smooth surface has wiggles.
    #[serde(default)]
    pub strained: usize,
}

impl From<InterpolationReport> for InterpolationFigures {
    fn from(report: InterpolationReport) -> Self {
        let InterpolationReport { iterations, residual, has_converged, inexact_rows, .. } = report;
        let InterpolationReport { placement, left_to_limit, strained, .. } = report;
        let placement = match placement {
            Placement::AlongNormals => "along-normals",
            Placement::AtLimit => AT_LIMIT,
        };
        Self {
            iterations,
            residual,
            has_converged,
            inexact_rows,
            placement: placement.into(),
            left_to_limit,
            strained,
        }
    }
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
        let made = hierarchy.finest().refinement.as_ref();
        let guard = made.and_then(|refinement| refinement.guard);
        let interpolation = made.and_then(|refinement| refinement.interpolation);
        Self {
            vertices: mesh.points().len(),
            tets: mesh.tets().len(),
            eta_min,
            eta_mean,
            volume: Some(volume(mesh)),
            limit: None,
            interpolation: interpolation.map(InterpolationFigures::from),
            guard: guard.map(|guard| GuardFigures {
                floor: guard.floor,
                pulled_back: guard.pulled_back,
                linear: guard.linear,
            }),
        }
    }
}

/// Summed by chunks, so that it does not depend on the number of threads.
fn volume(mesh: &TetMesh) -> f64 {
    let sums =
        map_ranges(mesh.tets().len(), |range| range.map(|tet| mesh.volume(tet)).sum::<f64>());
    sums.iter().sum()
}
