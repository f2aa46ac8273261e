//! What a solve did, also when it failed.

/// Iterations, residuals and times of one solve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolveReport {
    /// Iterations done.
    pub iterations: usize,
    /// ‖b − A x‖ / ‖b‖ of the solution, or of the best iterate where there is none;
    /// computed anew in double precision.
    pub relative_residual: f64,
    /// Relative residuals as the iteration saw them, the first that of the start
    /// (1 of zero); one more than iterations.
    pub residual_history: Vec<f64>,
    /// Seconds spent on building the preconditioner.
    pub setup_seconds: f64,
    /// Seconds spent on iterating.
    pub solve_seconds: f64,
}

/// What an iteration that did not reach its goal leaves behind.
#[derive(Clone, PartialEq)]
pub struct Unfinished {
    /// What was done and reached.
    pub report: SolveReport,
    /// The iterate with the smallest residual, which may be the start; only zero, from
    /// which every iteration of conjugate gradients leads nearer to the solution in
    /// the energy norm, is none there. Of a system of blocks three numbers for each
    /// row.
    pub iterate: Vec<f64>,
}

impl std::fmt::Debug for Unfinished {
    /// The report alone: the iterate may have millions of entries.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Unfinished").field("report", &self.report).finish_non_exhaustive()
    }
}
