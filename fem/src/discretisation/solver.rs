//! What solves a discretised problem, set up once and used as often as wanted.

use crate::boundary::level_unknowns::LevelUnknowns;
use crate::discretisation::discretise::Discretisation;
use crate::discretisation::full_multigrid::full_pass;
use crate::discretisation::solution::Solution;
use crate::discretisation::transfers::{TransferSummary, prolongations, summaries, transfers};
use crate::discretisation::unknown::Unknown;
use crate::error::Error;
use crate::options::choices::{Cycle, FullTransfer, Method};
use crate::options::prolongations::Prolongations;
use crate::options::solving::Options;
use octruss_solver::Error as SolverError;
use octruss_solver::{
    EachIteration, Multigrid, Nodal, Precision, SolveOptions, conjugate_gradients,
    stationary_iteration,
};
use std::time::Instant;

/// A multigrid for a discretised problem, with the options that it was set up with.
pub struct Solver<'d, E: Unknown = f64> {
    discretisation: &'d Discretisation<'d, E>,
    options: Options,
    /// The multigrid.
    pub multigrid: Multigrid<E>,
    /// What is known of each transfer, coarsest first.
    pub transfers: Vec<TransferSummary>,
    /// The time for prolongations, coarse matrices and factors.
    pub setup_seconds: f64,
}

impl<E: Unknown> Solver<'_, E> {
    /// What prolongs, asked for or usual.
    pub fn prolongation(&self) -> Prolongations {
        self.options.prolongation.unwrap_or(self.discretisation.usual_prolongation)
    }

    /// How full multigrid transfers, if it is asked for.
    pub fn full_transfer(&self) -> Option<FullTransfer> {
        self.options.full_transfer(self.discretisation.hierarchy)
    }

    /// Solves the problem; `progress` hears of each iteration and may stop it.
    ///
    /// Where the iteration stands still although its precision was left open, single
    /// precision inside the cycle is to blame more often than not: then the multigrid is set
    /// up again in double, and the iteration goes on.
    ///
    /// # Errors
    /// [`Error::NoLoad`] if nothing acts; as [`conjugate_gradients`], in [`Error::Solver`]:
    /// what an iteration left behind that did not reach its goal is in [`Error::unfinished`].
    pub fn solve(&mut self, progress: Option<EachIteration>) -> Result<Solution<E>, Error> {
        self.discretisation.check_loaded()?;
        let error = match self.attempt(None, progress) {
            Err(error) if self.options.precision.is_none() => error,
            done => return done,
        };
        let is_single = self.multigrid.options().precision == Precision::Single;
        let stalled = match &error {
            Error::Solver(SolverError::NotConverged(at)) if is_single && at.has_stalled() => at,
            Error::Solver(SolverError::NotPositiveDefinite { at, .. }) if is_single => at,
            _ => return Err(error),
        };
        let options = Options { precision: Some(Precision::Double), ..self.options };
        let seconds = self.setup_seconds;
        *self = self.discretisation.solver(&options)?;
        self.setup_seconds += seconds;
        let mut solution = self.attempt(Some(&stalled.iterate), progress)?;
        solution.report.follow(&stalled.report);
        Ok(solution)
    }

    /// One iteration, from `start` if there is one.
    fn attempt(
        &mut self,
        start: Option<&[f64]>,
        progress: Option<EachIteration>,
    ) -> Result<Solution<E>, Error> {
        let Discretisation { matrix, rhs, .. } = self.discretisation;
        let began = Instant::now();
        let full_transfer = self.full_transfer().filter(|_| start.is_none());
        let full_pass = full_transfer
            .map(|transfer| full_pass(transfer, self.discretisation, &mut self.multigrid))
            .transpose()?;
        let pass_seconds = began.elapsed().as_secs_f64();
        let stop = SolveOptions {
            start: start.or(full_pass.as_deref().map(Nodal::flat)),
            tolerance: self.options.tolerance,
            max_iterations: self.options.max_iterations,
            progress,
        };
        let (unknowns, mut report) = match self.options.method() {
            Method::ConjugateGradients => {
                conjugate_gradients(matrix, rhs, &mut self.multigrid, &stop)?
            }
            Method::Cycle => stationary_iteration(matrix, rhs, &mut self.multigrid, &stop)?,
        };
        report.setup_seconds = self.setup_seconds;
        report.solve_seconds += pass_seconds;
        Ok(Solution {
            values: self.discretisation.expand(&unknowns)?,
            full_multigrid_residual: full_pass.is_some().then_some(report.residual_history[0]),
            unknowns,
            report,
        })
    }
}

impl<E: Unknown> Discretisation<'_, E> {
    /// Sets up what solves it: transfers, coarse matrices, smoothers. The options may be
    /// others than those it was made with, as long as these provided for what they need.
    ///
    /// # Errors
    /// As [`Multigrid::with_transfers`]; [`octruss_solver::Error::Option`] for re-assembled
    /// matrices or full multigrid that it was not made for.
    pub fn solver(&self, options: &Options) -> Result<Solver<'_, E>, Error> {
        self.check_provided(options)?;
        let start = Instant::now();
        let made = prolongations(self.hierarchy, self.usual_prolongation, options);
        let transfers = transfers(self, &made, options)?;
        let projectors = self.levels.iter().map(|level| level.projectors.clone()).collect();
        let cycle = options.multigrid();
        let multigrid = Multigrid::with_transfers(
            &self.matrix,
            transfers,
            projectors,
            self.near_null_space(),
            &cycle,
        )?;
        let setup_seconds = start.elapsed().as_secs_f64();
        let transfers = summaries(self.hierarchy, &made);
        Ok(Solver { discretisation: self, options: *options, multigrid, transfers, setup_seconds })
    }

    /// What was not assembled for the options cannot be made up for.
    fn check_provided(&self, options: &Options) -> Result<(), Error> {
        let refuse = |option| {
            let expected = "what the discretisation was made with: give it the same options";
            Err(octruss_solver::Error::Option { option, expected }.into())
        };
        if options.reassembles() && self.coarse_matrices.len() < self.hierarchy.transfers() {
            return refuse("coarse_operator");
        }
        let is_homogeneous = self.levels.iter().all(LevelUnknowns::is_homogeneous);
        if options.cycle() == Cycle::Full && !is_homogeneous && self.coarsest.is_none() {
            return refuse("cycle");
        }
        Ok(())
    }

    /// Solves it.
    ///
    /// # Errors
    /// As [`Discretisation::solver`] and [`Solver::solve`].
    pub fn solve(&self, options: &Options) -> Result<Solution<E>, Error> {
        self.check_loaded()?;
        self.solver(options)?.solve(None)
    }
}
