//! What one variant on one level needs.

use serde::{Deserialize, Serialize};

use crate::null::null_as_nan;

/// A variant on a level. Iterations are those of conjugate gradients for noise on the
/// right; reductions are of the energy norm of the error by the cycle alone.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// `poisson`, `elasticity` or `biharmonic`.
    pub problem: String,
    /// The mesh file's name.
    pub body: String,
    /// `flat` or `subdivided`.
    pub geometry: String,
    /// What prolongs.
    pub prolongation: String,
    /// `galerkin` or `reassembled`.
    pub coarse_operator: String,
    /// `auto`, `on` or `off`.
    pub affine_correction: String,
    /// The greatest of all transfers, after correction, in mean edge lengths.
    #[serde(deserialize_with = "null_as_nan")]
    pub affine_defect: f64,
    /// The same before rows were corrected.
    #[serde(deserialize_with = "null_as_nan")]
    pub affine_defect_before: f64,
    /// `strata` or `linear`.
    pub interface_rows: String,
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
    #[serde(deserialize_with = "null_as_nan")]
    pub mean_reduction: f64,
    /// Mean factor of cycles 33 to 40.
    #[serde(deserialize_with = "null_as_nan")]
    pub asymptotic_reduction: f64,
    /// Nonzeros of all levels over those of the finest.
    #[serde(deserialize_with = "null_as_nan")]
    pub operator_complexity: f64,
    /// Bytes that an iteration must move, for a decimal digit of the residual.
    pub bytes_per_digit: Option<f64>,
    /// Work of iterations for a decimal digit, in products with the finest matrix.
    pub work_per_digit: Option<f64>,
    /// Prolongations, coarse matrices, factors: the median of the repeats.
    #[serde(deserialize_with = "null_as_nan")]
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
            self.coarse_operator.clone(),
            self.cycle.clone(),
            self.smoother.clone(),
            match self.affine_correction.as_str() {
                "auto" => String::new(),
                asked => format!("correction {asked}"),
            },
            match self.interface_rows.as_str() {
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
