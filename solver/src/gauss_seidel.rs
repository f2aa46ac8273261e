//! Gauss–Seidel sweeps: the serial reference smoother.

use crate::csr::Csr;
use crate::entry::{Entry, Nodal};
use crate::kernels::row_product;

/// The order in which a sweep visits the unknowns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Order {
    /// Ascending.
    Forward,
    /// Descending: the adjoint of a forward sweep in the energy product.
    Backward,
}

/// One sweep for A x = b: each unknown in turn solves its own equation.
pub(crate) fn sweep<E: Entry>(
    matrix: &Csr<E>,
    inverse_diagonal: &[E],
    b: &[E::Nodal],
    x: &mut [E::Nodal],
    order: Order,
) {
    let mut relax = |i: usize| {
        let r = b[i].minus(row_product(matrix, i, x));
        x[i] = inverse_diagonal[i].add_product(r, x[i]);
    };
    match order {
        Order::Forward => (0..matrix.rows()).for_each(&mut relax),
        Order::Backward => (0..matrix.rows()).rev().for_each(&mut relax),
    }
}
