//! What is prescribed on surfaces, and which unknowns are left.

pub mod constraints;
pub mod dofs;
pub mod held_vertex;
pub mod level_unknowns;
pub mod rigid_modes;
pub mod surface;
