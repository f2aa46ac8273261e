//! A finding of a check.

use octruss_mesh::Finding;
use serde::{Deserialize, Serialize};

/// A finding by name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FindingReport {
    /// The kind, in kebab case.
    pub kind: String,
    /// How often.
    pub count: usize,
    /// The first few places, as numbers of tets or vertices from 0.
    pub examples: Vec<u32>,
    /// All that, and what to do, in a sentence.
    pub message: String,
}

impl From<&Finding> for FindingReport {
    fn from(finding: &Finding) -> Self {
        Self {
            kind: finding.kind.name().into(),
            count: finding.count,
            examples: finding.examples.clone(),
            message: finding.to_string(),
        }
    }
}
