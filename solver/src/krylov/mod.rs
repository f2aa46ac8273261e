//! Iterations, and what they need to know of a matrix.

pub mod cg;
pub mod iteration;
pub mod lanczos;
pub mod operator;
pub mod preconditioner;
pub mod row_sums;
pub mod stationary;
