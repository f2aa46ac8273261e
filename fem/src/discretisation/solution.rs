//! What a solve found.

use crate::discretisation::unknown::Unknown;
use octruss_solver::SolveReport;

/// A solution, and what it took to find it.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution<E: Unknown = f64> {
    /// A value for each vertex of the finest level: a number, or a displacement; 0 at
    /// vertices that no tet uses.
    pub values: Vec<E::Nodal>,
    /// A value for each free unknown.
    pub unknowns: Vec<E::Nodal>,
    /// ‖b − A x‖ / ‖b‖ after the pass of full multigrid, if there was one, before the
    /// first iteration.
    pub full_multigrid_residual: Option<f64>,
    /// Iterations, residuals, times; the pass of full multigrid counts as solving.
    pub report: SolveReport,
}
