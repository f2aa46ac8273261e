//! Matrices between the levels of a hierarchy, whichever scheme made them.

pub mod affine_correction;
pub mod prolongation;
pub mod quadratic_matrix;
