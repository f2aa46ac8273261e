//! Multigrid: levels from a matrix, and prolongations as far as they are given.
//!
//! ```text
//! matrix, transfers ─▶ input ─▶ setup: level by level, Galerkin products down to coarse ─▶ cycle
//! ```

pub mod aggregation;
pub mod coarse;
pub mod cycle;
pub mod descent;
pub mod figures;
pub mod galerkin;
pub mod input;
pub mod level;
pub mod levels;
pub mod options;
pub mod projectors;
pub mod setup;
pub mod smoothed_prolongation;
pub mod smoother;
pub mod system_entry;
pub mod transfer;
pub mod two_parents;
pub mod weights;
