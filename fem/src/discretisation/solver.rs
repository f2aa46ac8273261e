//! What solves a discretised problem, set up once and used as often as wanted.

use crate::discretisation::discretise::Discretisation;
use crate::discretisation::full_multigrid::full_pass;
use crate::discretisation::solution::Solution;
use crate::discretisation::transfers::{TransferSummary, prolongations, summaries, transfers};
use crate::discretisation::unknown::Unknown;
use crate::error::Error;
use crate::options::choices::{FullTransfer, Method};
use crate::options::solving::Options;
use octruss_solver::{
    EachIteration, Multigrid, Nodal, SolveOptions, conjugate_gradients, stationary_iteration,
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

impl<'d, E: Unknown> Solver<'d, E> {
    /// Sets the multigrid up.
    ///
    /// # Errors
    /// As [`Multigrid::with_transfers`].
    pub(crate) fn new(
        discretisation: &'d Discretisation<'d, E>,
        options: &Options,
    ) -> Result<Self, Error> {
        let start = Instant::now();
        let made = prolongations(discretisation.hierarchy, options);
        let transfers = transfers(discretisation, &made, options)?;
        let projectors = discretisation.levels.iter().map(|level| level.projectors.clone());
        let (matrix, projectors) = (&discretisation.matrix, projectors.collect());
        let multigrid =
            Multigrid::with_transfers(matrix, transfers, projectors, &options.multigrid())?;
        let setup_seconds = start.elapsed().as_secs_f64();
        let transfers = summaries(discretisation.hierarchy, &made);
        Ok(Self { discretisation, options: *options, multigrid, transfers, setup_seconds })
    }

    /// How full multigrid transfers, if it is asked for.
    pub fn full_transfer(&self) -> Option<FullTransfer> {
        self.options.full_transfer(self.discretisation.hierarchy)
    }

    /// Solves the problem; `progress` hears of each iteration and may stop it.
    ///
    /// # Errors
    /// As [`conjugate_gradients`], in [`Error::Solver`]: what an iteration left behind
    /// that did not reach its goal is in [`Error::unfinished`].
    pub fn solve(&mut self, progress: Option<EachIteration>) -> Result<Solution<E>, Error> {
        let Discretisation { matrix, rhs, .. } = self.discretisation;
        let start = Instant::now();
        let full_pass = self
            .full_transfer()
            .map(|transfer| full_pass(transfer, self.discretisation, &mut self.multigrid))
            .transpose()?;
        let pass_seconds = start.elapsed().as_secs_f64();
        let stop = SolveOptions {
            start: full_pass.as_deref().map(Nodal::flat),
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
    /// Sets up what solves it: transfers, coarse matrices, smoothers.
    ///
    /// # Errors
    /// As [`Multigrid::with_transfers`].
    pub fn solver(&self, options: &Options) -> Result<Solver<'_, E>, Error> {
        Solver::new(self, options)
    }

    /// Solves it.
    ///
    /// # Errors
    /// As [`Discretisation::solver`] and [`Solver::solve`].
    pub fn solve(&self, options: &Options) -> Result<Solution<E>, Error> {
        self.solver(options)?.solve(None)
    }
}
