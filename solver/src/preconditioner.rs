//! What an iteration may use to turn residuals into corrections.

/// An approximate inverse of a symmetric positive definite matrix, itself
/// linear, symmetric and positive definite. `V` is what vectors hold for each row.
pub trait Preconditioner<V = f64> {
    /// z ≈ A⁻¹ r.
    fn apply(&mut self, r: &[V], z: &mut [V]);

    /// The seconds that building it took; they go into the report of a solve.
    fn setup_seconds(&self) -> f64 {
        0.0
    }
}

/// No preconditioner: z = r.
#[derive(Debug, Clone, Copy, Default)]
pub struct Identity;

impl<V: Copy> Preconditioner<V> for Identity {
    fn apply(&mut self, r: &[V], z: &mut [V]) {
        z.copy_from_slice(r);
    }
}
