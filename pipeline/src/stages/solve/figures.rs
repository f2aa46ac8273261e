//! What a solve took and reached, as the report tells it.

use octruss_base::choice::Choice;
use octruss_fem::{FullTransfer, Method, Options, Solution, Solver, TransferSummary, Unknown};
use octruss_mesh::CorrectedRows;
use octruss_solver::{Precision, Preconditioner, ResolvedOptions, Smoother};
use serde::Serialize;

use super::traffic::TrafficFigures;

/// What one solve took and reached.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolveFigures {
    /// By which expectations call it: the prolongation.
    pub name: String,
    /// What prolongs; if the finest transfer is apart, `FINEST/COARSER`.
    pub prolongation: String,
    /// Which rows were made exact for linear functions.
    pub affine_correction: &'static str,
    /// What rows on interfaces read.
    pub interface_rows: &'static str,
    /// Where coarse matrices come from.
    pub coarse_operator: &'static str,
    /// What it was done with.
    #[serde(flatten)]
    pub method: MethodFigures,
    /// Free unknowns on the finest level.
    pub unknowns: usize,
    /// How many levels the cycle has.
    pub levels: usize,
    /// Stored entries of the finest matrix.
    pub nonzeros: usize,
    /// Stored entries of all levels' matrices.
    pub nonzeros_all_levels: usize,
    /// Those over these: all levels over the finest.
    pub operator_complexity: f64,
    /// Unknowns of all levels over those of the finest.
    pub grid_complexity: f64,
    /// For each transfer, the coarsest first, how far it misses linear functions,
    /// in mean edge lengths.
    pub affine_defects: Vec<f64>,
    /// More about each transfer, the coarsest first.
    pub transfers: Vec<TransferFigures>,
    /// ‖b − A x‖ / ‖b‖ after the pass of full multigrid, before the first iteration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub full_multigrid_residual: Option<f64>,
    /// Iterations, one cycle each.
    pub iterations: usize,
    /// ‖b − A x‖ / ‖b‖ at the end.
    pub relative_residual: f64,
    /// Relative residuals from that of the start (1 of zero) on, one more than
    /// iterations.
    pub residual_history: Vec<f64>,
    /// The factor by which an iteration reduces the residual, geometric mean.
    pub mean_reduction: f64,
    /// Work for a decimal digit of the residual, in products with the finest
    /// matrix: a cycle and the product of the iteration itself.
    pub work_per_digit: f64,
    /// The least value at a vertex of a tet, of displacements their length.
    pub minimum: f64,
    /// The greatest value at a vertex of a tet, of displacements their length.
    pub maximum: f64,
    /// Prolongations, Galerkin products, factors; coarse matrices that are re-assembled
    /// count as assembly.
    pub setup_seconds: f64,
    /// Iterating, after the pass of full multigrid if there was one.
    pub solve_seconds: f64,
    /// Bytes and bandwidth of each kernel of a cycle, if asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub account: Option<TrafficFigures>,
}

impl SolveFigures {
    /// Of a solve; what the caller adds is the range of the solution, 0 here, the number
    /// of unknowns, and traffic if it is asked for.
    pub(super) fn new<E: Unknown>(
        options: &Options,
        solver: &Solver<E>,
        solution: &Solution<E>,
    ) -> Self {
        let (multigrid, report) = (&solver.multigrid, &solution.report);
        let cycles = report.iterations as f64;
        // Without an iteration nothing was reduced, and nothing done.
        let first_residual = report.residual_history[0];
        let reduced = if cycles > 0.0 { report.relative_residual / first_residual } else { 1.0 };
        let work = cycles * (multigrid.work_units() + 1.0);
        let transfers: Vec<TransferFigures> = solver.transfers.iter().map(Into::into).collect();
        Self {
            name: options.prolongation.to_string(),
            prolongation: options.prolongation.to_string(),
            affine_correction: Choice::name(options.affine_correction),
            interface_rows: Choice::name(options.interface_rows),
            coarse_operator: options.coarse_operator.name(),
            method: MethodFigures::new(options, solver, solver.full_transfer()),
            unknowns: 0,
            levels: multigrid.levels().len(),
            nonzeros: multigrid.finest().nonzeros,
            nonzeros_all_levels: multigrid.levels().iter().map(|level| level.nonzeros).sum(),
            operator_complexity: multigrid.operator_complexity(),
            grid_complexity: multigrid.grid_complexity(),
            affine_defects: transfers.iter().map(|t| t.affine_defect).collect(),
            transfers,
            full_multigrid_residual: solution.full_multigrid_residual,
            iterations: report.iterations,
            relative_residual: report.relative_residual,
            residual_history: report.residual_history.clone(),
            mean_reduction: reduced.powf(1.0 / cycles.max(1.0)),
            work_per_digit: if cycles > 0.0 { -work / reduced.log10() } else { 0.0 },
            minimum: 0.0,
            maximum: 0.0,
            setup_seconds: solver.setup_seconds,
            solve_seconds: report.solve_seconds,
            account: None,
        }
    }

    /// The outcome in a few words.
    pub fn result(&self) -> String {
        format!("{} iterations, residual {:.1e}", self.iterations, self.relative_residual)
    }
}

/// What is known of one transfer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TransferFigures {
    /// What prolongs.
    pub prolongation: &'static str,
    /// How far the matrix misses linear functions, in mean edge lengths; of
    /// `smoothed-linear` the one that is smoothed.
    pub affine_defect: f64,
    /// The same before rows were corrected.
    pub affine_defect_before: f64,
    /// Rows made exact on their own support.
    pub corrected_rows: usize,
    /// Rows made linear, which was exact.
    pub replaced_rows: usize,
    /// Rows made exact with more columns.
    pub extended_rows: usize,
    /// Rows that nothing made exact.
    pub left_rows: usize,
}

impl From<&TransferSummary> for TransferFigures {
    fn from(summary: &TransferSummary) -> Self {
        let CorrectedRows { corrected, replaced, extended, left } = summary.corrected;
        Self {
            prolongation: summary.prolongation,
            affine_defect: summary.affine_defect,
            affine_defect_before: summary.affine_defect_before,
            corrected_rows: corrected,
            replaced_rows: replaced,
            extended_rows: extended,
            left_rows: left,
        }
    }
}

/// What a solve was done with, by the names that configs use.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodFigures {
    /// `cg`, `flexible-cg` where the cycle is not symmetric, or `cycle`.
    pub method: &'static str,
    /// The shape of the cycle.
    pub cycle: &'static str,
    /// How full multigrid brought solutions to finer levels, where it did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub full_transfer: Option<&'static str>,
    /// What one sweep is.
    pub smoother: &'static str,
    /// The degree of the polynomial, where the smoother is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub smoothing_degree: Option<usize>,
    /// Sweeps before and after the coarse correction.
    pub sweeps: [usize; 2],
    /// The precision inside the cycle.
    pub precision: &'static str,
}

impl MethodFigures {
    /// What the multigrid of a solver is used as, and how its full pass transferred if it
    /// had one.
    pub(crate) fn new<E: Unknown>(
        options: &Options,
        solver: &Solver<E>,
        full_transfer: Option<FullTransfer>,
    ) -> Self {
        let multigrid = &solver.multigrid;
        let ResolvedOptions { smoother, before, after, precision, .. } = *multigrid.options();
        let method = match options.method() {
            Method::ConjugateGradients if !multigrid.is_symmetric() => "flexible-cg",
            method => method.name(),
        };
        let smoothing_degree = match smoother {
            Smoother::Chebyshev { degree, .. } => Some(degree),
            _ => None,
        };
        Self {
            method,
            cycle: options.cycle().name(),
            full_transfer: full_transfer.map(Choice::name),
            smoother: smoother.name(),
            smoothing_degree,
            sweeps: [before, after],
            precision: Precision::name(precision),
        }
    }

    /// The shape of the cycle with its sweeps: `v(1,1)`.
    pub fn cycle_and_sweeps(&self) -> String {
        let [before, after] = self.sweeps;
        format!("{}({before},{after})", self.cycle)
    }

    /// The smoother with its degree, if it has one: `chebyshev-3`.
    pub fn smoother_and_degree(&self) -> String {
        let degree = self.smoothing_degree.map(|degree| format!("-{degree}"));
        format!("{}{}", self.smoother, degree.unwrap_or_default())
    }
}
