//! What one solve took and reached.

use octruss_base::choice::Choice;
use octruss_fem::{Options, Solution, Solver, Unknown};
use octruss_solver::Ended;
use serde::{Deserialize, Serialize};

use super::method_figures::MethodFigures;
use super::traffic_figures::TrafficFigures;
use super::transfer_figures::TransferFigures;
use crate::null::{null_as_nan, nulls_as_nan};

/// What one solve took and reached.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SolveFigures {
    /// By which expectations call it: the prolongation.
    pub name: String,
    /// What prolongs; if the finest transfer is apart, `FINEST/COARSER`.
    pub prolongation: String,
    /// Which rows were made exact for linear functions.
    pub affine_correction: String,
    /// What rows on interfaces read.
    pub interface_rows: String,
    /// Where coarse matrices come from.
    pub coarse_operator: String,
    /// What it was done with.
    #[serde(flatten)]
    pub method: MethodFigures,
    /// Free unknowns on the finest level.
    pub unknowns: usize,
    /// How many levels the cycle has.
    pub levels: usize,
    /// How many of them lie below the coarsest mesh, made from matrices alone.
    #[serde(default)]
    pub algebraic_levels: usize,
    /// Stored entries of the finest matrix.
    pub nonzeros: usize,
    /// Stored entries of all levels' matrices.
    pub nonzeros_all_levels: usize,
    /// Those over these: all levels over the finest.
    #[serde(deserialize_with = "null_as_nan")]
    pub operator_complexity: f64,
    /// Unknowns of all levels over those of the finest.
    #[serde(deserialize_with = "null_as_nan")]
    pub grid_complexity: f64,
    /// For each transfer, the coarsest first, how far it misses linear functions,
    /// in mean edge lengths.
    #[serde(deserialize_with = "nulls_as_nan")]
    pub affine_defects: Vec<f64>,
    /// More about each transfer, the coarsest first.
    pub transfers: Vec<TransferFigures>,
    /// ‖b − A x‖ / ‖b‖ after the pass of full multigrid, before the first iteration.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub full_multigrid_residual: Option<f64>,
    /// Iterations, one cycle each.
    pub iterations: usize,
    /// ‖b − A x‖ / ‖b‖ at the end.
    #[serde(deserialize_with = "null_as_nan")]
    pub relative_residual: f64,
    /// What ended it: `residual`, as small as was asked for, or `rounding`, which allows no
    /// more.
    #[serde(default = "ended_by_residual")]
    pub ended: String,
    /// Where the residual alone did not end it: the largest share of rounding in a row, that
    /// is max |b − A x| / (|A| |x| + |b|).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub backward_error: Option<f64>,
    /// The estimated distance to the exact solution of the system in the energy norm, relative
    /// to the solution; none without conjugate gradients.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_error: Option<f64>,
    /// Relative residuals from that of the start (1 of zero) on, one more than
    /// iterations.
    #[serde(deserialize_with = "nulls_as_nan")]
    pub residual_history: Vec<f64>,
    /// The factor by which an iteration reduces the residual, geometric mean.
    #[serde(deserialize_with = "null_as_nan")]
    pub mean_reduction: f64,
    /// Work for a decimal digit of the residual, in products with the finest
    /// matrix: a cycle and the product of the iteration itself.
    #[serde(deserialize_with = "null_as_nan")]
    pub work_per_digit: f64,
    /// The least value at a vertex of a tet, of displacements their length.
    #[serde(deserialize_with = "null_as_nan")]
    pub minimum: f64,
    /// The greatest value at a vertex of a tet, of displacements their length.
    #[serde(deserialize_with = "null_as_nan")]
    pub maximum: f64,
    /// Prolongations, Galerkin products, factors; coarse matrices that are re-assembled
    /// count as assembly.
    #[serde(deserialize_with = "null_as_nan")]
    pub setup_seconds: f64,
    /// Iterating, and the pass of full multigrid before it if there was one.
    #[serde(deserialize_with = "null_as_nan")]
    pub solve_seconds: f64,
    /// Bytes and bandwidth of each kernel of a cycle, if asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub account: Option<TrafficFigures>,
}

impl SolveFigures {
    /// Of a solve whose solution has this `range`, the least and the greatest value;
    /// traffic is added by the caller if it is asked for.
    pub(crate) fn new<E: Unknown>(
        options: &Options,
        solver: &Solver<E>,
        solution: &Solution<E>,
        [minimum, maximum]: [f64; 2],
    ) -> Self {
        let (multigrid, report) = (&solver.multigrid, &solution.report);
        let cycles = report.iterations as f64;
        // Without an iteration nothing was reduced, and nothing done.
        let first_residual = report.residual_history[0];
        let reduced = if cycles > 0.0 { report.relative_residual / first_residual } else { 1.0 };
        let work = cycles * (multigrid.work_units() + 1.0);
        let transfers: Vec<TransferFigures> = solver.transfers.iter().map(Into::into).collect();
        Self {
            name: solver.prolongation().to_string(),
            prolongation: solver.prolongation().to_string(),
            affine_correction: Choice::name(options.affine_correction).into(),
            interface_rows: Choice::name(options.interface_rows).into(),
            coarse_operator: options.coarse_operator.name().into(),
            method: MethodFigures::new(options, solver),
            unknowns: multigrid.finest().unknowns,
            levels: multigrid.levels().len(),
            algebraic_levels: multigrid.algebraic_levels(),
            nonzeros: multigrid.finest().nonzeros,
            nonzeros_all_levels: multigrid.levels().iter().map(|level| level.nonzeros).sum(),
            operator_complexity: multigrid.operator_complexity(),
            grid_complexity: multigrid.grid_complexity(),
            affine_defects: transfers.iter().map(|t| t.affine_defect).collect(),
            transfers,
            full_multigrid_residual: solution.full_multigrid_residual,
            iterations: report.iterations,
            relative_residual: report.relative_residual,
            ended: report.ended.name().into(),
            backward_error: report.backward_error,
            energy_error: report.energy_error,
            residual_history: report.residual_history.clone(),
            mean_reduction: reduced.powf(1.0 / cycles.max(1.0)),
            work_per_digit: if cycles > 0.0 { -work / reduced.log10() } else { 0.0 },
            minimum,
            maximum,
            setup_seconds: solver.setup_seconds,
            solve_seconds: report.solve_seconds,
            account: None,
        }
    }

    /// The outcome in a few words.
    pub fn result(&self) -> String {
        let (iterations, residual) = (self.iterations, self.relative_residual);
        let end = match self.ended == Ended::Rounding.name() {
            true => ", as far as rounding allows",
            false => "",
        };
        format!("{iterations} iterations, residual {residual:.1e}{end}")
    }
}

/// What ended all solves of which older reports tell.
fn ended_by_residual() -> String {
    Ended::Residual.name().into()
}
