//! Why a level could not be added.

use octruss_mesh::SubdivideError;

use super::mesh_phase::Missing;

/// Why a level could not be added.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RefineError {
    /// There are no levels to add to.
    #[error(transparent)]
    Missing(#[from] Missing),
    /// The step was refused.
    #[error(transparent)]
    Subdivide(#[from] SubdivideError),
}
