//! What every iteration has in common: its goal, its history, its report.

use crate::error::{Error, check_finite, check_size};
use crate::krylov::operator::Operator;
use crate::report::{Ended, SolveReport, Unfinished};
use crate::sparse::backward_error::largest_share;
use crate::sparse::dot::{dot, norm};
use crate::sparse::entry::{Entry, Nodal};
use std::ops::ControlFlow;
use std::time::Instant;

/// Called after each iteration with its number and the relative residual;
/// `Break` stops the solve.
pub type EachIteration<'a> = &'a (dyn Fn(usize, f64) -> ControlFlow<()> + Sync);

/// Where to start, when to stop, and whom to tell.
#[derive(Clone, Copy)]
pub struct SolveOptions<'a> {
    /// The first iterate; zero if not given. Of a system of blocks three numbers for
    /// each row. One that is no nearer to the solution than zero, in the energy norm,
    /// is passed over, so that a poor start does not cost iterations.
    pub start: Option<&'a [f64]>,
    /// Stop when ‖b − A x‖ ≤ tolerance ‖b‖, in the Euclidean norm; conjugate gradients go on
    /// while they estimate the error in the energy norm at more than ten times the tolerance,
    /// relative to the solution.
    pub tolerance: f64,
    /// Give up after this many iterations.
    pub max_iterations: usize,
    /// Told after each iteration.
    pub progress: Option<EachIteration<'a>>,
}

impl Default for SolveOptions<'_> {
    /// From zero to 10⁻⁸ within 500 iterations, silently.
    fn default() -> Self {
        Self { start: None, tolerance: 1e-8, max_iterations: 500, progress: None }
    }
}

/// A backward error of some units of rounding: rows have dozens of entries.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The error in the energy norm may be this many times the tolerance. It hardly ever is: only
/// where the residual tells little of it, as where a soft part holds a stiff one.
const NEAR: f64 = 10.0;

/// By so many steps the convergence is judged.
const LAST_STEPS: usize = 6;

/// The factor between squares of steps that is taken for a standstill.
const SLOWEST: f64 = 0.99;

/// A solve under way.
pub(crate) struct Iteration<'a, E: Entry> {
    matrix: &'a dyn Operator<E>,
    rhs: &'a [E::Nodal],
    rhs_norm: f64,
    options: &'a SolveOptions<'a>,
    setup_seconds: f64,
    began: Instant,
    history: Vec<f64>,
    step_energies: Vec<f64>,
    /// How often an iterate was looked at in vain.
    looks: usize,
    /// Of the iterate that was looked at last, if any was: |A| |x| + |b|, and by that its
    /// backward error.
    row_sizes: Option<Vec<E::Nodal>>,
    backward_error: Option<f64>,
    best_norm: f64,
    /// The iterate with the smallest residual, unless it is the last.
    best: Option<Vec<E::Nodal>>,
}

impl<'a, E: Entry<Real = f64>> Iteration<'a, E> {
    /// Checks sizes and numbers.
    pub(crate) fn new(
        matrix: &'a dyn Operator<E>,
        rhs: &'a [E::Nodal],
        setup_seconds: f64,
        options: &'a SolveOptions<'a>,
    ) -> Result<Self, Error> {
        let began = Instant::now();
        matrix.check()?;
        check_size("entries of the right-hand side", rhs.len(), matrix.rows())?;
        check_finite("right-hand side", Nodal::flat(rhs))?;
        if options.tolerance < 0.0 || options.tolerance.is_nan() {
            return Err(Error::Option { option: "tolerance", expected: "0 or more" });
        }
        if let Some(start) = options.start {
            check_size("numbers of the start", start.len(), E::SIZE * matrix.rows())?;
            check_finite("start", start)?;
        }
        Ok(Self {
            matrix,
            rhs,
            rhs_norm: norm(rhs),
            options,
            setup_seconds,
            began,
            history: Vec::new(),
            step_energies: Vec::new(),
            looks: 0,
            row_sizes: None,
            backward_error: None,
            best_norm: f64::INFINITY,
            best: None,
        })
    }

    /// The first iterate and its residual; whether zero, should it be the first, may
    /// turn out as the best.
    pub(crate) fn first_iterate(&mut self, zero_counts: bool) -> (Vec<E::Nodal>, Vec<E::Nodal>) {
        let mut counts = zero_counts;
        let (mut x, mut r) = (vec![E::Nodal::default(); self.rhs.len()], self.rhs.to_vec());
        if let Some(start) = self.options.start {
            Nodal::flat_mut(&mut x).copy_from_slice(start);
            self.matrix.residual(&x, self.rhs, &mut r);
            // The squares of the energy norms of the errors of zero and of x, one
            // minus the other.
            let gain = dot(&x, self.rhs) + dot(&x, &r);
            if gain > 0.0 {
                counts = true;
            } else {
                x.fill(E::Nodal::default());
                r.copy_from_slice(self.rhs);
            }
        }
        let residual_norm = norm(&r);
        if counts {
            self.best_norm = residual_norm;
        }
        self.history.push(residual_norm / self.scale());
        (x, r)
    }

    /// Whether this many iterations are allowed.
    pub(crate) fn may_go_on(&self) -> bool {
        self.history.len() <= self.options.max_iterations
    }

    /// Whether a residual of this norm is small enough.
    pub(crate) fn is_small(&self, residual_norm: f64) -> bool {
        residual_norm <= self.options.tolerance * self.rhs_norm
    }

    /// Whether rounding allows no better solution than `x`, whose residual is `r`.
    pub(crate) fn is_at_rounding(&mut self, x: &[E::Nodal], r: &[E::Nodal]) -> bool {
        self.looks += 1;
        self.row_sizes = self.matrix.row_sizes(x, self.rhs);
        self.backward_error = self.row_sizes.as_ref().map(|sizes| largest_share(r, sizes));
        self.backward_error.is_some_and(|error| error <= ROUNDING)
    }

    /// Whether an iterate with the residual that a recurrence gives is worth to be looked at:
    /// small enough, and near enough to the solution as far as steps tell; or, once that was
    /// in vain twice, with a residual as small in every row as rounding makes the true one.
    pub(crate) fn is_worth_a_look(
        &self,
        (x, r): (&[E::Nodal], &[E::Nodal]),
        residual_norm: f64,
    ) -> bool {
        match &self.row_sizes {
            _ if residual_norm == 0.0 => true,
            Some(sizes) if self.looks > 1 => largest_share(r, sizes) <= f64::EPSILON,
            _ => {
                // Beyond rounding nothing can be asked for.
                let tolerance = self.options.tolerance.max(f64::EPSILON);
                let is_near = |error| error <= NEAR * tolerance;
                let is_small = residual_norm <= tolerance * self.rhs_norm;
                is_small && self.energy_error(x).is_none_or(is_near)
            }
        }
    }

    /// Notes that the iteration begins anew, from a residual of this norm.
    pub(crate) fn restart(&mut self, residual_norm: f64) {
        self.step_energies.clear();
        let scale = self.scale();
        if let Some(last) = self.history.last_mut() {
            *last = residual_norm / scale;
        }
    }

    /// Notes the square of the way, in the energy norm, of a step.
    pub(crate) fn note_step(&mut self, energy: f64) {
        self.step_energies.push(energy);
    }

    /// Notes the residual's norm after an iteration, and the iterate before it if
    /// that was better than all, this one included; `Break` if asked to stop.
    pub(crate) fn record(
        &mut self,
        residual_norm: f64,
        iterate_before: impl FnOnce() -> Vec<E::Nodal>,
    ) -> ControlFlow<()> {
        if residual_norm < self.best_norm {
            (self.best_norm, self.best) = (residual_norm, None);
        } else if self.best.is_none() {
            self.best = Some(iterate_before());
        }
        let relative = residual_norm / self.scale();
        let iteration = self.history.len();
        self.history.push(relative);
        self.options.progress.map_or(ControlFlow::Continue(()), |tell| tell(iteration, relative))
    }

    /// The solution with its report.
    pub(crate) fn finish(self, x: Vec<E::Nodal>, ended: Ended) -> (Vec<E::Nodal>, SolveReport) {
        let report = SolveReport { ended, ..self.report(&x) };
        (x, report)
    }

    /// What is left when the goal was not reached and `x` is the last iterate.
    pub(crate) fn unfinished(mut self, x: Vec<E::Nodal>) -> Box<Unfinished> {
        let x = self.best.take().unwrap_or(x);
        let report = self.report(&x);
        Box::new(Unfinished { report, iterate: Nodal::flat(&x).to_vec() })
    }

    /// What residuals are relative to.
    fn scale(&self) -> f64 {
        if self.rhs_norm == 0.0 { 1.0 } else { self.rhs_norm }
    }

    /// What the steps to come would go, over the size of the solution, in the energy norm:
    /// the squares of steps go on as a geometric series.
    fn energy_error(&self, x: &[E::Nodal]) -> Option<f64> {
        let steps = &self.step_energies[self.step_energies.len().saturating_sub(LAST_STEPS)..];
        let [first, .., last] = steps else { return None };
        let factor = (last / first).powf(1.0 / (steps.len() - 1) as f64).min(SLOWEST);
        let energy = dot(x, self.rhs);
        (energy > 0.0).then(|| (last * factor / (1.0 - factor) / energy).sqrt())
    }

    fn report(self, x: &[E::Nodal]) -> SolveReport {
        let mut r = vec![E::Nodal::default(); x.len()];
        self.matrix.residual(x, self.rhs, &mut r);
        // Looked at before is not this iterate for sure.
        let sizes = self.backward_error.and_then(|_| self.matrix.row_sizes(x, self.rhs));
        SolveReport {
            iterations: self.history.len() - 1,
            relative_residual: norm(&r) / self.scale(),
            ended: Ended::default(),
            backward_error: sizes.map(|sizes| largest_share(&r, &sizes)),
            energy_error: self.energy_error(x),
            residual_history: self.history,
            setup_seconds: self.setup_seconds,
            solve_seconds: self.began.elapsed().as_secs_f64(),
        }
    }
}
