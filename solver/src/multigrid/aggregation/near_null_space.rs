//! What a matrix nearly sends to zero.

/// The vectors without energy that the levels below the given ones carry, where nothing is
/// held: without them on the coarse levels, cycles would need more with every refinement.
#[derive(Debug, Clone, PartialEq)]
pub enum NearNullSpace {
    /// Constants, in each component for itself.
    Constants,
    /// Displacements without deformation of vertices at these positions, one for each row
    /// of the coarsest given level: three translations, three rotations. Only for a matrix
    /// of blocks.
    RigidMotions(Vec<[f64; 3]>),
}
