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
use crate::options::prolongations::Prolongations;
use crate::options::solving::Options;
use octruss_solver::Error as SolverError;
use octruss_solver::{
    EachIteration, Entry, Multigrid, Nodal, Operator, Precision, SolveOptions, SolveReport,
    Unfinished, WithRowSums, conjugate_gradients, stationary_iteration,
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
        let discretisation = self.discretisation;
        discretisation.check_loaded()?;
        let began = Instant::now();
        let full_pass = self
            .full_transfer()
            .map(|transfer| full_pass(transfer, discretisation, &mut self.multigrid))
            .transpose()?;
        let pass_seconds = began.elapsed().as_secs_f64();
        let solved = match self.iterate(full_pass.as_deref().map(Nodal::flat), progress) {
            Err(error) => match self.lost_to_single_precision(&error) {
                Some(earlier) => self.go_on_in_double(earlier, progress)?,
                None => Err(error),
            },
            solved => solved,
        };
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

    /// Iterates from `start`, or zero.
    fn iterate(&mut self, start: Option<&[f64]>, progress: Option<EachIteration>) -> Iterated<E> {
        let discretisation = self.discretisation;
        let (matrix, rhs) = (&discretisation.matrix, discretisation.solved_rhs());
        let with_sums = discretisation.row_sums.as_deref();
        let with_sums = with_sums.map(|sums| WithRowSums::new(matrix, sums)).transpose()?;
        let matrix = with_sums.as_ref().map_or(matrix as &dyn Operator<E>, |known| known);
        let stop = SolveOptions {
            start,
            tolerance: self.options.tolerance,
            max_iterations: self.options.max_iterations,
            progress,
        };
        let method = self.options.method();
        projected(discretisation.free.as_ref(), &mut self.multigrid, |cycle| match method {
            Method::ConjugateGradients => conjugate_gradients(matrix, rhs, cycle, &stop),
            Method::Cycle => stationary_iteration(matrix, rhs, cycle, &stop),
        })
    }

    /// What an iteration reached that stood still with single precision inside the cycle,
    /// although nobody asked for that.
    fn lost_to_single_precision<'e>(&self, error: &'e SolverError) -> Option<&'e Unfinished> {
        let is_open = self.options.precision.is_none();
        let may_go_on = |at: &Unfinished| at.report.iterations < self.options.max_iterations;
        let is_single = self.multigrid.options().precision == Precision::Single;
        match error {
            SolverError::NotConverged(at) if at.has_stalled() => Some(at),
            SolverError::NotPositiveDefinite { at, .. } => Some(at),
            _ => None,
        }
        .map(|at| &**at)
        .filter(|at| is_open && is_single && may_go_on(at))
    }

    /// Goes on where an iteration stood still, with a cycle in double precision.
    fn go_on_in_double(
        &mut self,
        earlier: &Unfinished,
        progress: Option<EachIteration>,
    ) -> Result<Iterated<E>, Error> {
        let left = self.options.max_iterations.saturating_sub(earlier.report.iterations);
        let precision = Some(Precision::Double);
        let options = Options { precision, max_iterations: left, ..self.options };
        let seconds = self.setup_seconds;
        *self = self.discretisation.solver(&options)?;
        self.setup_seconds += seconds;
        let mut solved = self.iterate(Some(&earlier.iterate), progress);
        match &mut solved {
            Ok((_, report)) => report.follow(&earlier.report),
            Err(error) => {
                let later = error.unfinished_mut().map(|at| &mut at.report);
                later.into_iter().for_each(|report| report.follow(&earlier.report));
            }
        }
        Ok(solved)
    }
}

/// Unknowns and report of an iteration, or why it stopped.
type Iterated<E> = Result<(Vec<<E as Entry>::Nodal>, SolveReport), SolverError>;

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
        let matrix = regularised(&self.matrix, self.free.as_ref());
        let multigrid = Multigrid::with_transfers(
            &matrix,
            transfers,
            projectors,
            self.near_null_space.clone(),
            &cycle,
        )
        .map_err(|error| self.told_of_the_mesh(error))?;
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
        self.check_loaded()?;
        self.solver(options)?.solve(None)
    }
}
