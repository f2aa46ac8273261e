//! From a mesh and a problem to a matrix and a right-hand side.

pub mod biharmonic;
pub mod blame;
pub mod edge_rows;
pub mod elasticity;
pub mod elasticity_load;
pub mod foundation;
pub mod load;
pub mod poisson;
pub mod poisson_load;
pub mod scatter;
