//! What a solve did, also when it failed.

/// Which goal ended an iteration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ended {
    /// The residual that was asked for.
    #[default]
    Residual,
    /// Rounding allows no more: the solution is that of a system which differs from the
    /// given one by rounding in each number, see [`backward_error`](crate::backward_error).
    Rounding,
}

impl Ended {
    /// As reports call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Residual => "residual",
            Self::Rounding => "rounding",
        }
    }
}

/// Iterations, residuals and times of one solve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolveReport {
    /// Iterations done.
    pub iterations: usize,
    /// ‖b − A x‖ / ‖b‖ of the solution, or of the best iterate where there is none;
    /// computed anew in double precision.
    pub relative_residual: f64,
    /// Which goal ended it; where none was reached without meaning.
    pub ended: Ended,
    /// [`backward_error`](crate::backward_error) of the solution where that was looked at:
    /// where the residual alone did not end the iteration.
    pub backward_error: Option<f64>,
    /// How far the solution is from the exact one, in the energy norm and relative to the
    /// solution, as conjugate gradients estimate it: the squares of their steps add up to that
    /// of the distance (Hestenes and Stiefel 1952), and those to come are extrapolated from
    /// the last ones. None after a single step and of other methods.
    pub energy_error: Option<f64>,
    /// Relative residuals as the iteration saw them, the first that of the start
    /// (1 of zero); one more than iterations.
    pub residual_history: Vec<f64>,
    /// Seconds spent on building the preconditioner.
    pub setup_seconds: f64,
    /// Seconds spent on iterating.
    pub solve_seconds: f64,
}

impl SolveReport {
    /// Adds what an earlier iteration did, from which this one went on.
    pub fn follow(&mut self, earlier: &Self) {
        self.iterations += earlier.iterations;
        self.solve_seconds += earlier.solve_seconds;
        // Where this one starts is where the other ended.
        let own = self.residual_history.iter().skip(1);
        self.residual_history = earlier.residual_history.iter().chain(own).copied().collect();
    }
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

impl Unfinished {
    /// Whether the last quarter of the iterations, at least ten, did not halve the residual
    /// that was reached before.
    pub fn has_stalled(&self) -> bool {
        let history = &self.report.residual_history;
        let last = (history.len() / 4).max(10);
        let smallest = |part: &[f64]| part.iter().copied().fold(f64::INFINITY, f64::min);
        let Some(before) = history.len().checked_sub(last) else { return false };
        let [before, after] = [&history[..before], &history[before..]].map(smallest);
        after >= 0.5 * before
    }
}

impl std::fmt::Debug for Unfinished {
    /// The report alone: the iterate may have millions of entries.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Unfinished").field("report", &self.report).finish_non_exhaustive()
    }
}
