//! What is prescribed on surfaces, and which unknowns are left.

pub mod constraints;
pub mod dofs;
pub mod held_vertex;
pub mod hinged_bodies;
pub mod level_unknowns;
pub mod locking;
pub mod motions;
pub mod noisy_planes;
pub mod rigid_modes;
pub mod surface;
pub mod surface_normals;
