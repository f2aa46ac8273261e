//! The convergence study as a product: prolongations, cycles and geometries on one
//! problem, side by side.
//!
//! ```text
//! Recipe ─▶ Plan ─▶ for each geometry and level: Variants ─▶ Rows ─▶ Verdict
//!                                           └─▶ CarriedSolutions (coarse ones, interpolated)
//! ```

mod attempt;
mod carried;
mod carried_solution;
mod found;
mod level_study;
#[cfg(feature = "pictures")]
mod picture;
mod plan;
mod row;
mod study;
mod text;
mod verdict;

pub use carried_solution::CarriedSolution;
pub use found::Comparison;
pub use row::Row;
pub use study::compare;
