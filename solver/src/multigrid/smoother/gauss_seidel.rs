//! Gauss–Seidel sweeps: row after row as the serial reference, or colour after
//! colour.

use crate::multigrid::smoother::colouring::Colouring;
use crate::sparse::csr::Csr;
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::kernels::row_product;
use octruss_base::chunks::for_chunks;

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
        let r = b[i].minus(row_product(matrix.row(i), x));
        x[i] = inverse_diagonal[i].add_product(r, x[i]);
    };
    match order {
        Order::Forward => (0..matrix.rows()).for_each(&mut relax),
        Order::Backward => (0..matrix.rows()).rev().for_each(&mut relax),
    }
}

/// One sweep through the colours. New values of one colour are computed in parallel
/// into `buffer`, then put in place.
pub(crate) fn coloured_sweep<E: Entry>(
    (matrix, inverse_diagonal): (&Csr<E>, &[E]),
    (colouring, buffer): (&Colouring, &mut [E::Nodal]),
    (b, x): (&[E::Nodal], &mut [E::Nodal]),
    order: Order,
) {
    let mut relax = |rows: &[u32]| {
        let new = &mut buffer[..rows.len()];
        for_chunks(new, |first, chunk| {
            for (new, &i) in chunk.iter_mut().zip(&rows[first..]) {
                let i = i as usize;
                let r = b[i].minus(row_product(matrix.row(i), x));
                *new = inverse_diagonal[i].add_product(r, x[i]);
            }
        });
        rows.iter().zip(new).for_each(|(&i, new)| x[i as usize] = *new);
    };
    match order {
        Order::Forward => colouring.rows().for_each(&mut relax),
        Order::Backward => colouring.rows().rev().for_each(&mut relax),
    }
}
