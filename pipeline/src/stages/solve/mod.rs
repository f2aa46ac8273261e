//! Solving on the finest mesh, once with each prolongation.
//!
//! ```text
//! keys of a problem ─▶ fem::Problem ─▶ Discretisation ─▶ in turn: Solver ─▶ Solution, figures
//! ```

pub mod biharmonic;
pub mod body;
pub mod deformation;
pub mod elasticity;
pub mod equation;
pub mod fixed;
pub mod free_parts;
pub mod in_turn;
pub mod keys;
pub mod locked_supports;
pub mod outcome;
pub mod poisson;
pub mod problem_keys;
pub mod stage;
pub mod unfinished;
