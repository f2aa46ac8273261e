//! What a stage did.

use serde::{Deserialize, Serialize};

use super::check_report::CheckReport;
use super::import_report::ImportReport;
use super::solve::SolveStageReport;
use super::subdivide::SubdivideReport;
use super::write_report::WriteReport;

/// What one stage did.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StageReport {
    /// The stage's label, see [`crate::recipe::stage_labels`].
    pub name: String,
    /// Wall time.
    pub seconds: f64,
    /// The kind of the stage as `kind`, and what depends on it.
    #[serde(flatten)]
    pub done: Done,
}

/// What one stage did, by the kind of the stage.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Done {
    /// Of a stage `import`.
    Import(ImportReport),
    /// Of a stage `check`.
    Check(CheckReport),
    /// Of a stage `subdivide`.
    Subdivide(Box<SubdivideReport>),
    /// Of a stage `solve`.
    Solve(SolveStageReport),
    /// Of a stage `write`.
    Write(WriteReport),
}

impl Done {
    /// The outcome in a line.
    pub fn summary(&self) -> String {
        match self {
            Self::Import(report) => report.summary(),
            Self::Check(report) => report.summary(),
            Self::Subdivide(report) => report.summary(),
            Self::Solve(report) => report.summary(),
            Self::Write(report) => report.summary(),
        }
    }
}
