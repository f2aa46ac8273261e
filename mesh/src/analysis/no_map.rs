//! Why there is no characteristic map.

/// Why there is no characteristic map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NoMap {
    /// The matrix has fewer than four rows.
    #[error("there are fewer than four eigenvalues")]
    TooFew,
    /// λ1 to λ3 are not all real.
    #[error("λ1 to λ3 are not all real")]
    Complex,
    /// λ3 and λ4 have the same modulus.
    #[error("λ3 is not larger than λ4")]
    NotSeparated,
    /// λ1 to λ3 have fewer than three independent eigenvectors.
    #[error("λ1 to λ3 have no three independent eigenvectors")]
    Dependent,
}
