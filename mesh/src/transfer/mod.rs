//! Matrices between the levels of a hierarchy, whichever scheme made them.

pub mod prolongation;
pub mod quadratic_matrix;
