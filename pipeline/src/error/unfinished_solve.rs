//! A solve that did not reach its goal.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::null::{null_as_nan, nulls_as_nan};

/// A solve that stopped before its goal: asked to, out of iterations, or because the
/// system is not positive definite.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, thiserror::Error)]
#[error(
    "stage `{stage}`, {what}: {reason}; the last residuals: {}; the iterate with the smallest \
     is in {}",
    last_of(residual_history), file.display()
)]
pub struct UnfinishedSolve {
    /// The stage's label.
    pub stage: String,
    /// Which of its solves.
    pub what: String,
    /// Why it stopped.
    pub reason: String,
    /// Iterations done.
    pub iterations: usize,
    /// ‖b − A x‖ / ‖b‖ of the iterate that was kept.
    #[serde(deserialize_with = "null_as_nan")]
    pub relative_residual: f64,
    /// Relative residuals from that of the start (1 of zero) on, one more than
    /// iterations.
    #[serde(deserialize_with = "nulls_as_nan")]
    pub residual_history: Vec<f64>,
    /// The finest mesh with the iterate.
    pub file: PathBuf,
}

/// The end of a residual history: whether the iteration was slow, stood still or blew
/// up.
fn last_of(history: &[f64]) -> String {
    let last = &history[history.len().saturating_sub(5)..];
    last.iter().map(|residual| format!("{residual:.1e}")).collect::<Vec<_>>().join(", ")
}
