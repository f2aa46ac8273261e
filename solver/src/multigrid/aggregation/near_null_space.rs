//! What a matrix nearly sends to zero.

/// The vectors without energy that the levels below the given ones carry, where nothing is
/// held: without them on the coarse levels, cycles would need more with every refinement.
#[derive(Debug, Clone, PartialEq)]
pub enum NearNullSpace {
    /// Constants, in each component for itself.
    Constants,
    /// Nothing is known: the coarsest given level is solved directly as long as that can be
    /// done at all; where it is larger, levels below it carry constants.
    Unknown,
    /// Displacements without deformation of vertices at these positions, one for each row
    /// of the coarsest given level: three translations, three rotations. Only for a matrix
    /// of blocks.
    RigidMotions(Vec<[f64; 3]>),
}
