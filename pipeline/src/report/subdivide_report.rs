//! What refining did.

use std::collections::BTreeMap;

use octruss_mesh::quality::mean_ratio_range;
use octruss_mesh::{FeatureReasons, Hierarchy, MarkingReport, Reason, Scheme, marking_report};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

use super::carried_fields::CarriedFields;
use crate::amount::short;

/// All levels, the coarsest first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SubdivideReport {
    /// The scheme's name.
    pub scheme: String,
    /// The tension, of interpolatory schemes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<f64>,
    /// The weight of an interior vertex itself, of `loop-solid`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interior: Option<f64>,
    /// Vertices of the finest level.
    pub vertices: usize,
    /// Tets of the finest level.
    pub tets: usize,
    /// What stays sharp on the coarsest level.
    pub strata: StrataCounts,
    /// The marking of the coarsest level.
    pub marking: MarkingFigures,
    /// What became of the fields.
    pub fields: CarriedFields,
    /// Options that had no effect, and remarks on fields.
    pub notes: Vec<String>,
    /// One a level.
    pub levels: Vec<LevelReport>,
}

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

/// How far the marking agrees, before it is chosen and after.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MarkingFigures {
    /// Faces between two tets.
    pub interior_faces: usize,
    /// Those whose tets marked different edges in the order they came in.
    pub conflicting_faces_before: usize,
    /// The same as marked.
    pub conflicting_faces: usize,
    /// How many interior edges of level 1 have so many tets round them, in the
    /// order they came in.
    #[serde(deserialize_with = "by_number")]
    pub edge_valences_before: BTreeMap<u32, usize>,
    /// The same as marked.
    #[serde(deserialize_with = "by_number")]
    pub edge_valences: BTreeMap<u32, usize>,
}

/// Counts by numbers: within something larger, serde takes keys of JSON for text alone.
fn by_number<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<u32, usize>, D::Error> {
    let counts = BTreeMap::<String, usize>::deserialize(deserializer)?;
    let number = |(key, count): (String, usize)| Ok((key.parse()?, count));
    let counts: Result<_, std::num::ParseIntError> = counts.into_iter().map(number).collect();
    counts.map_err(D::Error::custom)
}

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

impl SubdivideReport {
    /// Of the level at hand, before any other is made.
    pub(crate) fn new(
        scheme: Scheme,
        hierarchy: &Hierarchy,
        unmarked: Option<MarkingReport>,
        strata: StrataCounts,
    ) -> Self {
        let level = LevelReport { guard: None, ..LevelReport::of_finest(hierarchy) };
        let marked = marking_report(&hierarchy.finest().topology);
        let (mut tension, mut interior) = (None, None);
        match scheme {
            Scheme::Interpolatory { tension: w, .. } => tension = Some(w),
            Scheme::LoopSolid { interior: c } => interior = Some(c),
            Scheme::Linear | Scheme::BoxSpline | Scheme::Averaged => {}
        }
        Self {
            scheme: scheme.name().into(),
            tension,
            interior,
            vertices: level.vertices,
            tets: level.tets,
            strata,
            marking: MarkingFigures::new(unmarked.unwrap_or_else(|| marked.clone()), marked),
            fields: CarriedFields::default(),
            notes: Vec::new(),
            levels: vec![level],
        }
    }

    pub(crate) fn add(&mut self, level: LevelReport) {
        (self.vertices, self.tets) = (level.vertices, level.tets);
        self.levels.push(level);
    }

    pub(crate) fn summary(&self) -> String {
        let (vertices, tets) = (short(self.vertices), short(self.tets));
        format!("{} scheme: {vertices} vertices, {tets} tets", self.scheme)
    }
}

impl StrataCounts {
    pub(crate) fn of_finest(hierarchy: &Hierarchy, reasons: Option<&FeatureReasons>) -> Self {
        let mesh = &hierarchy.finest().mesh;
        let topology = &hierarchy.finest().topology;
        let features = mesh.features().cloned().unwrap_or_default();
        let strata = octruss_mesh::Strata::new(mesh.raw(), topology, &features);
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

impl MarkingFigures {
    fn new(before: MarkingReport, after: MarkingReport) -> Self {
        Self {
            interior_faces: after.interior_faces,
            conflicting_faces_before: before.conflicting_faces,
            conflicting_faces: after.conflicting_faces,
            edge_valences_before: before.split_edge_valences.into_iter().collect(),
            edge_valences: after.split_edge_valences.into_iter().collect(),
        }
    }
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
