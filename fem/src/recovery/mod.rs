//! What a solution means: strains, stresses, forces, errors.

pub mod forces;
pub mod nodal;
pub mod norms;
pub mod stress;
