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
    /// For each vertex what its value differs by from a constant or a rigid motion, where
    /// values are prescribed far from zero: see [`Solution::differences`].
    pub difference: Option<Vec<E::Nodal>>,
    /// The relative residual after the pass of full multigrid, if there was one, before the
    /// first iteration.
    pub full_multigrid_residual: Option<f64>,
    /// Iterations, residuals, times; the pass of full multigrid counts as solving.
    /// Residuals are relative to the right-hand side, of the difference where there is one.
    pub report: SolveReport,
}

impl<E: Unknown> Solution<E> {
    /// What to compute gradients from, and with them fluxes, strains and stresses: a value
    /// for each vertex that has the same, `values` less a constant or a rigid motion where
    /// values are prescribed far from zero. There `values` have lost digits that this has.
    pub fn differences(&self) -> &[E::Nodal] {
        self.difference.as_deref().unwrap_or(&self.values)
    }
}
