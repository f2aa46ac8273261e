//! What solves a discretised problem, set up once and used as often as wanted.

use crate::boundary::level_unknowns::LevelUnknowns;
use crate::discretisation::discretise::{Discretisation, measured_from_zero};
use crate::discretisation::full_multigrid::full_pass;
use crate::discretisation::problem::regularised;
use crate::discretisation::solution::Solution;
use crate::discretisation::transfers::{TransferSummary, prolongations, summaries, transfers};
use crate::discretisation::unknown::Unknown;
use crate::error::Error;
use crate::free::free_bodies::projected;
use crate::options::choices::{Cycle, FullTransfer, Method};
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

impl<E: Unknown> Solver<'_, E> {
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
        let discretisation = self.discretisation;
        let (matrix, rhs) = (&discretisation.matrix, discretisation.solved_rhs());
        let start = Instant::now();
        let full_pass = self
            .full_transfer()
            .map(|transfer| full_pass(transfer, discretisation, &mut self.multigrid))
            .transpose()?;
        let pass_seconds = start.elapsed().as_secs_f64();
        let stop = SolveOptions {
            start: full_pass.as_deref().map(Nodal::flat),
            tolerance: self.options.tolerance,
            max_iterations: self.options.max_iterations,
            progress,
        };
        let method = self.options.method();
        let free = discretisation.free.as_ref();
        let solved = projected(free, &mut self.multigrid, |cycle| match method {
            Method::ConjugateGradients => conjugate_gradients(matrix, rhs, cycle, &stop),
            Method::Cycle => stationary_iteration(matrix, rhs, cycle, &stop),
        });
        let (mut x, mut report) = solved.map_err(|error| discretisation.told(error))?;
        report.setup_seconds = self.setup_seconds;
        report.solve_seconds += pass_seconds;
        discretisation.centre(&mut x);
        let difference = discretisation.difference.as_ref().map(|difference| {
            discretisation.project(&mut x);
            difference.expand(discretisation.finest().dofs.free(), &x)
        });
        let unknowns = discretisation.unknowns_of(x);
        Ok(Solution {
            values: discretisation.expand(&unknowns)?,
            full_multigrid_residual: full_pass.is_some().then_some(report.residual_history[0]),
            unknowns,
            difference,
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
        let made = prolongations(self.hierarchy, options);
        let transfers = transfers(self, &made, options)?;
        let projectors = self.levels.iter().map(|level| level.projectors.clone()).collect();
        let cycle = options.multigrid();
        let matrix = regularised(&self.matrix, self.free.as_ref());
        let multigrid = Multigrid::with_transfers(&matrix, transfers, projectors, &cycle)?;
        drop(matrix);
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

    /// The right-hand side that is solved for: that of the difference where there is one.
    pub(crate) fn solved_rhs(&self) -> &[E::Nodal] {
        self.difference.as_ref().map_or(&self.rhs, |difference| &difference.rhs)
    }

    /// The unknowns of the problem from those that were solved for.
    fn unknowns_of(&self, x: Vec<E::Nodal>) -> Vec<E::Nodal> {
        measured_from_zero(self.difference.as_ref(), self.finest(), x)
    }

    /// Takes what may be added to free parts out of the solution that these unknowns, of the
    /// difference where there is one, belong to.
    fn centre(&self, x: &mut [E::Nodal]) {
        let Some(free) = &self.free else { return };
        let whole = self.unknowns_of(x.to_vec());
        let mut centred = whole.clone();
        free.centre(&mut centred);
        for ((x, whole), centred) in x.iter_mut().zip(&whole).zip(&centred) {
            *x = x.plus(centred.minus(*whole));
        }
    }

    /// An error with an iterate of the problem itself, if it has one.
    fn told(&self, mut error: octruss_solver::Error) -> Error {
        if let Some(at) = error.unfinished_mut() {
            let x = E::Nodal::from_flat(&at.iterate);
            at.iterate = Nodal::flat(&self.unknowns_of(x)).to_vec();
        }
        error.into()
    }

    /// Solves it.
    ///
    /// # Errors
    /// As [`Discretisation::solver`] and [`Solver::solve`].
    pub fn solve(&self, options: &Options) -> Result<Solution<E>, Error> {
        self.solver(options)?.solve(None)
    }
}
