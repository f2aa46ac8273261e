//! The figures of one level.

use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;

/// Where a level comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LevelOrigin {
    /// The finest, or below a prolongation that was given.
    Given,
    /// Made from the matrix of the level above by smoothed aggregation.
    Algebraic,
}

impl LevelOrigin {
    /// As tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::Algebraic => "algebraic",
        }
    }
}

/// What one level holds.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelSummary {
    /// Where it comes from.
    pub origin: LevelOrigin,
    /// Rows of its matrix, three a block.
    pub unknowns: usize,
    /// Stored numbers of its matrix, nine a block.
    pub nonzeros: usize,
    /// Memory of matrices, factors and work vectors.
    pub bytes: usize,
    /// Stored entries of the prolongation onto it; none on the coarsest level.
    pub prolongation_nonzeros: Option<usize>,
    /// The estimate for D⁻¹A; none on the coarsest level, which is not smoothed, and
    /// with smoothers that need none.
    pub largest_eigenvalue: Option<f64>,
}

impl LevelSummary {
    /// The size of a matrix, nothing else.
    pub(crate) fn of<E: Entry>(matrix: &Csr<E>) -> Self {
        Self {
            origin: LevelOrigin::Given,
            unknowns: matrix.rows() * E::SIZE,
            nonzeros: matrix.nonzeros() * E::SIZE * E::SIZE,
            bytes: 0,
            prolongation_nonzeros: None,
            largest_eigenvalue: None,
        }
    }

    /// Stored entries a row of its matrix.
    pub fn nonzeros_per_row(&self) -> f64 {
        self.nonzeros as f64 / self.unknowns.max(1) as f64
    }
}
