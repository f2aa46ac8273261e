//! Parts of a body that nothing holds, as the solver sees them.

use crate::free::balance::Balance;
use crate::free::null_space::NullSpace;
use octruss_solver::{Csr, Entry, Nodal, Preconditioner};

/// The parts of a body that nothing holds, or not in all directions: their matrix maps
/// constants, or rigid motions, to zero, and their loads were balanced so that there is a
/// solution.
///
/// A preconditioner is set up from the matrix with a little added to its diagonal
/// ([`regularised`](Self::regularised)); conjugate gradients run on the matrix itself.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeBodies<V> {
    /// What the matrix maps to zero.
    pub null_space: NullSpace<V>,
    /// What was added to the loads of each part.
    pub balances: Vec<Balance>,
    /// The volume round each unknown of these parts times a ten-thousandth of a number near
    /// the part's smallest eigenvalue other than 0; 0 for unknowns of other parts.
    pub shift: Vec<f64>,
    /// ∫ ρ m φ at each unknown for each constant or rigid motion m of its part, with the
    /// density ρ, or 1: the solution is orthogonal to these.
    pub means: Vec<Vec<V>>,
}

/// How much is added to the diagonal, relative to what the smallest eigenvalue is near to. A
/// part that is long and thin, or has soft joints, has smaller ones; single precision bears
/// as much.
pub(crate) const SHIFT: f64 = 1e-4;

impl<V: Nodal<Real = f64>> FreeBodies<V> {
    /// The matrix with the shift added to its diagonal, which is positive definite.
    pub fn regularised<E: Entry<Real = f64, Nodal = V>>(&self, matrix: &Csr<E>) -> Csr<E> {
        matrix.plus_diagonal(&self.shift)
    }

    /// Takes constants or rigid motions out of a solution: what is left has no mean over the
    /// mass, or the volume, of each part.
    pub fn centre(&self, x: &mut [V]) {
        self.null_space.centre(&self.means, x);
    }
}

/// Iterates with a preconditioner, of free parts with one whose corrections have nothing in
/// their null space.
pub(crate) fn projected<V: Nodal<Real = f64>, R>(
    free: Option<&FreeBodies<V>>,
    inner: &mut dyn Preconditioner<V>,
    iterate: impl FnOnce(&mut dyn Preconditioner<V>) -> R,
) -> R {
    match free {
        None => iterate(inner),
        Some(free) => iterate(&mut Projected { inner, null_space: &free.null_space }),
    }
}

struct Projected<'a, V> {
    inner: &'a mut dyn Preconditioner<V>,
    null_space: &'a NullSpace<V>,
}

impl<V: Nodal<Real = f64>> Preconditioner<V> for Projected<'_, V> {
    fn apply(&mut self, r: &[V], z: &mut [V]) {
        self.inner.apply(r, z);
        self.null_space.project(z);
    }

    fn is_symmetric(&self) -> bool {
        self.inner.is_symmetric()
    }

    fn setup_seconds(&self) -> f64 {
        self.inner.setup_seconds()
    }
}
