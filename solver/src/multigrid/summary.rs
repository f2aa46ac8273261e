//! The multigrid's table of itself.

use crate::multigrid::setup::Multigrid;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use std::fmt;

/// What one level holds.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelSummary {
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

impl<E: Entry> fmt::Display for Multigrid<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:>5}  {:>10}  {:>11}  {:>7}  {:>9}  {:>9}",
            "level", "unknowns", "nonzeros", "per row", "MiB", "λmax"
        )?;
        for (number, level) in self.levels().iter().enumerate() {
            let eigenvalue = match (level.largest_eigenvalue, level.prolongation_nonzeros) {
                (Some(value), _) => format!("{value:.3}"),
                (None, Some(_)) => "–".into(),
                (None, None) => "direct".into(),
            };
            writeln!(
                f,
                "{number:>5}  {:>10}  {:>11}  {:>7.1}  {:>9.2}  {eigenvalue:>9}",
                level.unknowns,
                level.nonzeros,
                level.nonzeros_per_row(),
                level.bytes as f64 / f64::from(1 << 20),
            )?;
        }
        write!(
            f,
            "grid complexity {:.3}, operator complexity {:.3}, work of a cycle {:.2} products",
            self.grid_complexity(),
            self.operator_complexity(),
            self.work_units()
        )
    }
}

impl<E: Entry> fmt::Debug for Multigrid<E> {
    /// The table: levels hold too many numbers to print.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
