//! The weights of a prolongation: numbers, which act on all components alike, or
//! entries as the matrix has them.

use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::kernels::{add_product, product};
use crate::sparse::transpose::transpose;

/// A prolongation, or a restriction.
pub(crate) enum Weights<E: Entry> {
    /// What meshes give.
    Numbers(Csr<E::Real>),
    /// What smoothing by a matrix of blocks makes of it.
    Entries(Csr<E>),
}

impl<E: Entry> Weights<E> {
    /// y = W x.
    pub(crate) fn product(&self, x: &[E::Nodal], y: &mut [E::Nodal]) {
        match self {
            Self::Numbers(weights) => product(weights, x, y),
            Self::Entries(weights) => product(weights, x, y),
        }
    }

    /// y += W x.
    pub(crate) fn add_product(&self, x: &[E::Nodal], y: &mut [E::Nodal]) {
        match self {
            Self::Numbers(weights) => add_product(weights, x, y),
            Self::Entries(weights) => add_product(weights, x, y),
        }
    }

    pub(crate) fn transposed(&self) -> Self {
        match self {
            Self::Numbers(weights) => Self::Numbers(transpose(weights)),
            Self::Entries(weights) => Self::Entries(transpose(weights)),
        }
    }

    pub(crate) fn rows(&self) -> usize {
        match self {
            Self::Numbers(weights) => weights.rows(),
            Self::Entries(weights) => weights.rows(),
        }
    }

    pub(crate) fn columns(&self) -> usize {
        match self {
            Self::Numbers(weights) => weights.columns(),
            Self::Entries(weights) => weights.columns(),
        }
    }

    /// How many multiplications a product takes.
    pub(crate) fn multiplications(&self) -> usize {
        match self {
            Self::Numbers(weights) => weights.nonzeros() * E::SIZE,
            Self::Entries(weights) => weights.nonzeros() * E::SIZE * E::SIZE,
        }
    }

    /// The memory of the arrays, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        match self {
            Self::Numbers(weights) => weights.bytes(),
            Self::Entries(weights) => weights.bytes(),
        }
    }
}
