//! The equations, with coefficients by region and data by surface.

pub mod biharmonic;
pub mod by_region;
pub mod elasticity;
pub mod free;
pub mod poisson;
pub mod scalar;
