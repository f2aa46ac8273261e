//! One variant on one level: what it needs.

use std::time::Instant;

use octruss_fem::{Discretisation, Error, Options, Solver, TransferSummary, Unknown};
use octruss_solver::{
    Csr, CycleShape, Entry, Multigrid, Nodal, SolveReport, geometric_mean, noise, reductions,
};
use serde::Serialize;

use super::attempt::attempt;
use crate::options::{Choice, Geometry};
use crate::report::MethodFigures;
use crate::stages::Context;

/// A variant on a level. Iterations are those of conjugate gradients for noise on the
/// right; reductions are of the energy norm of the error by the cycle alone.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// `poisson`, `elasticity` or `biharmonic`.
    pub problem: &'static str,
    /// The mesh file's name.
    pub body: String,
    /// `flat` or `subdivided`.
    pub geometry: &'static str,
    /// What prolongs.
    pub prolongation: String,
    /// `galerkin` or `reassembled`.
    pub coarse_operator: &'static str,
    /// `auto`, `on` or `off`.
    pub affine_correction: &'static str,
    /// The greatest of all transfers, after correction, in mean edge lengths.
    pub affine_defect: f64,
    /// The same before rows were corrected.
    pub affine_defect_before: f64,
    /// `strata` or `linear`.
    pub interface_rows: &'static str,
    /// Such as `V(2,2)`.
    pub cycle: String,
    /// Such as `chebyshev-3`.
    pub smoother: String,
    /// The finest level; the input is 0.
    pub level: usize,
    /// Free unknowns there.
    pub unknowns: usize,
    /// Iterations to the tolerance of the stage; none if it was not reached.
    pub iterations: Option<usize>,
    /// Mean factor of cycles 13 to 20.
    pub mean_reduction: f64,
    /// Mean factor of cycles 33 to 40.
    pub asymptotic_reduction: f64,
    /// Nonzeros of all levels over those of the finest.
    pub operator_complexity: f64,
    /// Bytes that an iteration must move, for a decimal digit of the residual.
    pub bytes_per_digit: Option<f64>,
    /// Work of iterations for a decimal digit, in products with the finest matrix.
    pub work_per_digit: Option<f64>,
    /// Prolongations, coarse matrices, factors: the median of the repeats.
    pub setup_seconds: f64,
    /// Iterating: the median of the repeats; none if the tolerance was not reached.
    pub solve_seconds: Option<f64>,
    /// The shortest and the longest set-up.
    pub setup_spread: [f64; 2],
    /// The shortest and the longest solve.
    pub solve_spread: [Option<f64>; 2],
}

impl Row {
    /// What is varied, in words: all that is not as it is by default.
    pub fn variant(&self) -> String {
        let parts = [
            self.prolongation.clone(),
            self.coarse_operator.into(),
            self.cycle.clone(),
            self.smoother.clone(),
            match self.affine_correction {
                "auto" => String::new(),
                asked => format!("correction {asked}"),
            },
            match self.interface_rows {
                "strata" => String::new(),
                asked => format!("{asked} interfaces"),
            },
        ];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
    }

    /// The outcome in a few words.
    pub fn result(&self) -> String {
        match self.iterations {
            Some(iterations) => format!("{iterations} iterations"),
            None => "not converged".into(),
        }
    }
}

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
            problem: self.problem,
            body: self.body.into(),
            geometry: self.geometry.name(),
            prolongation: options.prolongation.to_string(),
            coarse_operator: options.coarse_operator.name(),
            affine_correction: Choice::name(options.affine_correction),
            affine_defect: worst(|transfer| transfer.affine_defect),
            affine_defect_before: worst(|transfer| transfer.affine_defect_before),
            interface_rows: Choice::name(options.interface_rows),
            cycle: format!("{}({},{})", shape, cycle.before, cycle.after),
            smoother: MethodFigures::new(options, &solver, None).smoother_and_degree(),
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
        let start = Instant::now();
        let solver = self.discrete.solver(options)?;
        let reassembly = if options.reassembles() { self.discrete.reassembly_seconds } else { 0.0 };
        Ok((solver, reassembly + start.elapsed().as_secs_f64()))
    }

    /// Noise in the free directions.
    fn right_hand_side(&self) -> Vec<E::Nodal> {
        let numbers = noise(self.discrete.unknowns(), 17);
        let rows = numbers.chunks_exact(E::SIZE);
        let mut rhs: Vec<E::Nodal> = rows.map(|row| Nodal::from_fn(|k| row[k])).collect();
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
