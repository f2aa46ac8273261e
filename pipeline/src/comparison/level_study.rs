//! The variants on one level: set up, solved, measured.

use octruss_base::choice::Choice;
use octruss_fem::{Discretisation, Error, Options, Solver, TransferSummary, Unknown};
use octruss_solver::{
    Csr, CycleShape, Entry, Multigrid, Nodal, SolveReport, geometric_mean, noise, reductions,
};

use super::attempt::attempt;
use super::row::Row;
use crate::options::Geometry;
use crate::report::MethodFigures;
use crate::stages::Context;

/// Cycles, and which of them count.
const CYCLES: usize = 40;
const MEAN: std::ops::Range<usize> = 12..20;
const ASYMPTOTIC: std::ops::Range<usize> = 32..40;

/// What all variants on a level have in common.
pub(super) struct LevelStudy<'a, E: Unknown> {
    pub problem: &'static str,
    pub body: &'a str,
    pub geometry: Geometry,
    pub discrete: &'a Discretisation<'a, E>,
    pub repeats: usize,
    pub context: &'a Context<'a>,
}

impl<E: Unknown> LevelStudy<'_, E> {
    /// Sets up and solves one variant.
    ///
    /// # Errors
    /// Whatever the solver reports, but that it did not converge.
    pub fn row(&self, options: &Options) -> Result<Row, Error> {
        let (mut setups, mut solves) = (Vec::new(), Vec::new());
        let (mut solver, setup) = self.set_up(options)?;
        let figures = std::mem::take(&mut solver.transfers);
        let cycle = *solver.multigrid.options();
        setups.push(setup);
        let rhs = self.right_hand_side();
        let mut report = self.solve(&rhs, &mut solver.multigrid, options)?;
        for _ in 1..self.repeats {
            solves.extend(report.as_ref().map(|report| report.solve_seconds));
            // Never two at once.
            drop(solver);
            let again = self.set_up(options)?;
            solver = again.0;
            setups.push(again.1);
            report = self.solve(&rhs, &mut solver.multigrid, options)?;
        }
        solves.extend(report.as_ref().map(|report| report.solve_seconds));
        let factors = reductions(&self.discrete.matrix, &mut solver.multigrid, CYCLES)?;
        let per_digit = |cost: f64| {
            let report = report.as_ref().filter(|report| report.relative_residual > 0.0)?;
            Some(cost * report.iterations as f64 / -report.relative_residual.log10())
        };
        let (setup_seconds, setup_spread) = median_and_spread(setups).unwrap_or_default();
        let (solve_seconds, solve_spread) = median_and_spread(solves).unzip();
        let shape = match cycle.shape {
            CycleShape::V => "V",
            CycleShape::W => "W",
        };
        let worst =
            |defect: fn(&TransferSummary) -> f64| figures.iter().map(defect).fold(0.0, f64::max);
        Ok(Row {
            problem: self.problem.into(),
            body: self.body.into(),
            geometry: self.geometry.name().into(),
            prolongation: solver.prolongation().to_string(),
            coarse_operator: options.coarse_operator.name().into(),
            affine_correction: Choice::name(options.affine_correction).into(),
            affine_defect: worst(|transfer| transfer.affine_defect),
            affine_defect_before: worst(|transfer| transfer.affine_defect_before),
            interface_rows: Choice::name(options.interface_rows).into(),
            cycle: format!("{}({},{})", shape, cycle.before, cycle.after),
            smoother: MethodFigures::new(options, &solver).smoother_and_degree(),
            level: self.discrete.hierarchy.transfers(),
            unknowns: self.discrete.unknowns(),
            iterations: report.as_ref().map(|report| report.iterations),
            mean_reduction: geometric_mean(&factors[MEAN]),
            asymptotic_reduction: geometric_mean(&factors[ASYMPTOTIC]),
            operator_complexity: solver.multigrid.operator_complexity(),
            bytes_per_digit: per_digit(
                (solver.multigrid.cycle_bytes() + iteration_bytes(&self.discrete.matrix)) as f64,
            ),
            work_per_digit: per_digit(solver.multigrid.work_units() + 1.0),
            setup_seconds,
            solve_seconds,
            setup_spread,
            solve_spread: [0, 1].map(|end| solve_spread.map(|spread| spread[end])),
        })
    }

    /// What solves it, and the time of it all, coarse matrices that are re-assembled
    /// included.
    fn set_up(&self, options: &Options) -> Result<(Solver<'_, E>, f64), Error> {
        let solver = self.discrete.solver(options)?;
        let reassembly = if options.reassembles() { self.discrete.reassembly_seconds } else { 0.0 };
        let seconds = reassembly + solver.setup_seconds;
        Ok((solver, seconds))
    }

    /// Noise in the free directions.
    fn right_hand_side(&self) -> Vec<E::Nodal> {
        let mut rhs = E::Nodal::from_flat(&noise(self.discrete.unknowns(), 17));
        self.discrete.project(&mut rhs);
        rhs
    }

    /// None if the tolerance was not reached.
    fn solve(
        &self,
        rhs: &[E::Nodal],
        multigrid: &mut Multigrid<E>,
        options: &Options,
    ) -> Result<Option<SolveReport>, Error> {
        let solved = attempt(options, (self.discrete, rhs), multigrid, self.context)?;
        Ok(solved.map(|(_, report)| report))
    }
}

/// The bytes of an iteration of conjugate gradients beside the cycle: its product, and
/// thirteen passes over vectors (product 2, scalar product 2, direction 3, advance 6).
fn iteration_bytes<E: Entry>(matrix: &Csr<E>) -> usize {
    matrix.bytes() + 13 * matrix.rows() * size_of::<E::Nodal>()
}

/// The median, and the least and greatest, if there is any.
fn median_and_spread(mut seconds: Vec<f64>) -> Option<(f64, [f64; 2])> {
    seconds.sort_by(f64::total_cmp);
    let (&least, &greatest) = (seconds.first()?, seconds.last()?);
    Some((seconds[seconds.len() / 2], [least, greatest]))
}
