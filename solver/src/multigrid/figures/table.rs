//! The multigrid's table of itself.

use crate::multigrid::setup::Multigrid;
use crate::multigrid::system_entry::SystemEntry;
use std::fmt;

impl<E: SystemEntry> fmt::Display for Multigrid<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:>5}  {:<9}  {:>10}  {:>11}  {:>7}  {:>9}  {:>9}",
            "level", "origin", "unknowns", "nonzeros", "per row", "MiB", "λmax"
        )?;
        for (number, level) in self.levels().iter().enumerate() {
            let eigenvalue = match (level.largest_eigenvalue, level.prolongation_nonzeros) {
                (Some(value), _) => format!("{value:.3}"),
                (None, Some(_)) => "–".into(),
                (None, None) => "direct".into(),
            };
            writeln!(
                f,
                "{number:>5}  {:<9}  {:>10}  {:>11}  {:>7.1}  {:>9.2}  {eigenvalue:>9}",
                level.origin.name(),
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

impl<E: SystemEntry> fmt::Debug for Multigrid<E> {
    /// The table: levels hold too many numbers to print.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
