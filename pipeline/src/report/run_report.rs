//! A whole run.

use serde::{Deserialize, Serialize};

use super::outcome::Outcome;
use super::stage_report::StageReport;
use crate::error::UnfinishedSolve;

/// The schema of the reports that this version writes, 1 being the first. It is
/// raised where a key changes its meaning or disappears; a key that is added does not
/// raise it.
pub const SCHEMA: u32 = 1;

/// A whole run. In the file, null stands for a number that came out infinite or as
/// none at all, and reads back as NaN; that of something optional, as nothing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// What the keys mean: [`SCHEMA`] where this version wrote it.
    pub schema: u32,
    /// The version of the program.
    pub octruss: String,
    /// The recipe's name.
    pub config: String,
    /// How many threads worked.
    pub threads: usize,
    /// Wall time of all stages.
    pub seconds: f64,
    /// The process's greatest resident size up to the end of this run; null
    /// where the system does not tell.
    pub peak_memory_bytes: Option<u64>,
    /// In the order in which they ran.
    pub stages: Vec<StageReport>,
    /// What was expected, with what was measured; empty of a run that did not finish.
    pub expectations: Vec<Outcome>,
    /// The solve that did not reach its goal, if one did not; `stages` are those
    /// before it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unfinished: Option<UnfinishedSolve>,
}
