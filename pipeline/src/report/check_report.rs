//! What the check of a mesh found.

use serde::{Deserialize, Serialize};

use super::finding_report::FindingReport;

/// What was found; nothing of it stopped the run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckReport {
    /// Vertices kept.
    pub vertices: usize,
    /// Tets, all of positive volume.
    pub tets: usize,
    /// Repaired faults and remarks.
    pub findings: Vec<FindingReport>,
}

impl CheckReport {
    /// The outcome in a line.
    pub fn summary(&self) -> String {
        if self.findings.is_empty() {
            return "sound".into();
        }
        let messages = self.findings.iter().map(|finding| finding.message.as_str());
        messages.collect::<Vec<_>>().join("\n  ")
    }
}
