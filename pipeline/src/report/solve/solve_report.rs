//! What a stage `solve` did.

use serde::{Deserialize, Serialize};

use super::body_figures::BodyFigures;
use super::free_part_figures::FreePartFigures;
use super::solve_figures::SolveFigures;
use crate::null::null_as_nan;

/// All solves of a stage.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SolveStageReport {
    /// Which equation.
    pub problem: String,
    /// The time to assemble it, once for all solves: also the coarse matrices that are
    /// re-assembled, and the direct solve of the coarsest level from which full multigrid
    /// lifts prescribed values.
    #[serde(deserialize_with = "null_as_nan")]
    pub assembly_seconds: f64,
    /// One a prolongation.
    pub solves: Vec<SolveFigures>,
    /// What may surprise; left out where there is nothing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Parts that nothing holds, with what balances their loads.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub free_parts: Vec<FreePartFigures>,
    /// Of an elastic body, what else is of interest.
    #[serde(default, flatten, skip_serializing_if = "Option::is_none")]
    pub body: Option<BodyFigures>,
}

impl SolveStageReport {
    /// The outcome in a line.
    pub fn summary(&self) -> String {
        let iterations: Vec<String> = self
            .solves
            .iter()
            .map(|solve| format!("{} in {} iterations", solve.prolongation, solve.iterations))
            .collect();
        iterations.join(", ")
    }
}
