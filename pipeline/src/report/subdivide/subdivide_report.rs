//! What refining did.

use octruss_mesh::{Hierarchy, MarkingReport, Scheme, marking_report};
use serde::{Deserialize, Serialize};

use super::carried_fields::CarriedFields;
use super::level_report::LevelReport;
use super::marking_figures::MarkingFigures;
use super::strata_counts::StrataCounts;
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

impl SubdivideReport {
    /// Of the level at hand, before any other is made.
    pub(crate) fn new(
        scheme: Scheme,
        hierarchy: &Hierarchy,
        unmarked: Option<MarkingReport>,
        strata: StrataCounts,
    ) -> Self {
        let level =
            LevelReport { guard: None, interpolation: None, ..LevelReport::of_finest(hierarchy) };
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
