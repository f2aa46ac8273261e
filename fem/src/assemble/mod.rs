//! From a mesh and a problem to a matrix and a right-hand side.

pub mod biharmonic;
pub mod blame;
pub mod edge_rows;
pub mod elasticity;
pub mod elasticity_load;
pub mod foundation;
pub mod inertia_relief;
pub mod load;
pub mod lumped;
pub mod poisson;
pub mod poisson_load;
pub mod regularisation;
pub mod scatter;
pub mod uniform_source;
