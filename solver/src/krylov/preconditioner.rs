//! What an iteration may use to turn residuals into corrections.

/// An approximate inverse of a symmetric positive definite matrix, itself
/// positive definite and, best, linear and symmetric. `V` is what vectors hold for each row.
pub trait Preconditioner<V = f64> {
    /// z ≈ A⁻¹ r.
    fn apply(&mut self, r: &[V], z: &mut [V]);

    /// Whether it is linear and symmetric; if not, conjugate gradients run in their
    /// flexible form.
    fn is_symmetric(&self) -> bool {
        true
    }

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
