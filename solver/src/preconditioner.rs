//! What an iteration may use to turn residuals into corrections.

/// An approximate inverse of a symmetric positive definite matrix, itself
/// linear, symmetric and positive definite.
pub trait Preconditioner {
    /// z ≈ A⁻¹ r.
    fn apply(&mut self, r: &[f64], z: &mut [f64]);

    /// The seconds that building it took; they go into the report of a solve.
    fn setup_seconds(&self) -> f64 {
        0.0
    }
}

/// No preconditioner: z = r.
#[derive(Debug, Clone, Copy, Default)]
pub struct Identity;

impl Preconditioner for Identity {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        z.copy_from_slice(r);
    }
}
