//! Levels below those that were given, from the matrix alone: smoothed aggregation
//! (Vaněk, Mandel and Brezina 1996).
//!
//! ```text
//! matrix ─▶ strength of connection ─▶ aggregates ─┐
//! near-null space ────────────────────────────────┴▶ tentative ─▶ smoothed prolongation
//! ```

pub mod aggregates;
pub mod candidates;
pub mod coarsening;
pub mod near_null_space;
pub mod nodes;
pub mod orthonormal;
pub mod strength;
pub mod tentative;
