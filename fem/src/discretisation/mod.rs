//! A problem on a hierarchy, from its matrices to its solution.
//!
//! ```text
//! Hierarchy, Problem, Options ─▶ Discretisation ─▶ Solver ─▶ Solution
//! ```

pub mod discretise;
pub mod full_multigrid;
pub mod lost_to_rounding;
pub mod problem;
pub mod solution;
pub mod solver;
pub mod transfers;
pub mod unknown;
