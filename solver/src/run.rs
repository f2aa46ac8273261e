//! What every iteration has in common: its goal, its history, its report.

use crate::csr::Csr;
use crate::dot::norm;
use crate::entry::{Entry, Nodal};
use crate::error::{Error, check_finite, check_size};
use crate::kernels::residual;
use crate::report::{SolveReport, Unfinished};
use std::ops::ControlFlow;
use std::time::Instant;

/// Called after each iteration with its number and the relative residual;
/// `Break` stops the solve.
pub type Progress<'a> = &'a (dyn Fn(usize, f64) -> ControlFlow<()> + Sync);

/// When to stop, and whom to tell.
#[derive(Clone, Copy)]
pub struct SolveOptions<'a> {
    /// Stop when ‖b − A x‖ ≤ tolerance ‖b‖, in the Euclidean norm.
    pub tolerance: f64,
    /// Give up after this many iterations.
    pub max_iterations: usize,
    /// Told after each iteration.
    pub progress: Option<Progress<'a>>,
}

impl Default for SolveOptions<'_> {
    /// 10⁻⁸ within 200 iterations, silently.
    fn default() -> Self {
        Self { tolerance: 1e-8, max_iterations: 200, progress: None }
    }
}

/// A solve under way.
pub(crate) struct Run<'a, E: Entry> {
    matrix: &'a Csr<E>,
    rhs: &'a [E::Nodal],
    rhs_norm: f64,
    options: &'a SolveOptions<'a>,
    setup_seconds: f64,
    start: Instant,
    history: Vec<f64>,
}

impl<'a, E: Entry<Real = f64>> Run<'a, E> {
    /// Checks sizes and numbers; the first residual is the right-hand side.
    pub(crate) fn new(
        matrix: &'a Csr<E>,
        rhs: &'a [E::Nodal],
        setup_seconds: f64,
        options: &'a SolveOptions<'a>,
    ) -> Result<Self, Error> {
        let start = Instant::now();
        check_size("columns of the matrix", matrix.columns(), matrix.rows())?;
        check_size("entries of the right-hand side", rhs.len(), matrix.rows())?;
        check_finite("matrix", E::flat(matrix.values()))?;
        check_finite("right-hand side", Nodal::flat(rhs))?;
        if options.tolerance < 0.0 || options.tolerance.is_nan() {
            return Err(Error::Option { option: "tolerance", expected: "0 or more" });
        }
        let rhs_norm = norm(rhs);
        let history = vec![if rhs_norm == 0.0 { 0.0 } else { 1.0 }];
        Ok(Self { matrix, rhs, rhs_norm, options, setup_seconds, start, history })
    }

    /// Whether the solution is zero.
    pub(crate) fn is_trivial(&self) -> bool {
        self.rhs_norm == 0.0
    }

    /// Whether this many iterations are allowed.
    pub(crate) fn may_go_on(&self) -> bool {
        self.history.len() <= self.options.max_iterations
    }

    /// Whether a residual of this norm is small enough.
    pub(crate) fn is_small(&self, residual_norm: f64) -> bool {
        residual_norm <= self.options.tolerance * self.rhs_norm
    }

    /// Notes the residual's norm after an iteration; `Break` if asked to stop.
    pub(crate) fn record(&mut self, residual_norm: f64) -> ControlFlow<()> {
        let relative = residual_norm / self.rhs_norm;
        let iteration = self.history.len();
        self.history.push(relative);
        self.options.progress.map_or(ControlFlow::Continue(()), |tell| tell(iteration, relative))
    }

    /// The solution with its report.
    pub(crate) fn finish(self, x: Vec<E::Nodal>) -> (Vec<E::Nodal>, SolveReport) {
        let report = self.report(&x);
        (x, report)
    }

    /// What is left when the goal was not reached.
    pub(crate) fn unfinished(self, x: Vec<E::Nodal>) -> Box<Unfinished> {
        let report = self.report(&x);
        Box::new(Unfinished { report, iterate: Nodal::flat(&x).to_vec() })
    }

    fn report(self, x: &[E::Nodal]) -> SolveReport {
        let mut r = vec![E::Nodal::default(); x.len()];
        residual(self.matrix, x, self.rhs, &mut r);
        let scale = if self.rhs_norm == 0.0 { 1.0 } else { self.rhs_norm };
        SolveReport {
            iterations: self.history.len() - 1,
            relative_residual: norm(&r) / scale,
            residual_history: self.history,
            setup_seconds: self.setup_seconds,
            solve_seconds: self.start.elapsed().as_secs_f64(),
        }
    }
}
