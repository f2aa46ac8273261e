//! The mesh of a run, on its way from a file to levels.

use octruss_mesh::{Hierarchy, TetMesh};
use octruss_meshio::Dataset;

use crate::error::needs_before;

/// One mesh in the phase that the stages so far have brought it to.
#[derive(Debug, Default)]
pub enum MeshPhase {
    /// There is none yet.
    #[default]
    Nothing,
    /// What the file says.
    Imported(Dataset),
    /// Fit to work with.
    Checked(TetMesh),
    /// The coarsest level and those made from it.
    Levels(Hierarchy),
}

/// The kind of stage without which there is not what was asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{}", needs_before("it", stage))]
pub struct Missing {
    /// As configs call it.
    pub stage: &'static str,
}

const IMPORT: Missing = Missing { stage: "import" };
const CHECK: Missing = Missing { stage: "check" };

impl MeshPhase {
    /// The finest mesh.
    ///
    /// # Errors
    /// If nothing is checked.
    pub fn finest(&self) -> Result<&TetMesh, Missing> {
        match self {
            Self::Checked(mesh) => Ok(mesh),
            Self::Levels(hierarchy) => Ok(&hierarchy.finest().mesh),
            Self::Nothing | Self::Imported(_) => Err(CHECK),
        }
    }

    /// The levels.
    ///
    /// # Errors
    /// If nothing is checked, or the checked mesh is not a level yet.
    pub fn levels(&self) -> Result<&Hierarchy, Missing> {
        if let Self::Levels(hierarchy) = self { Ok(hierarchy) } else { Err(CHECK) }
    }

    /// The levels, to add to them.
    ///
    /// # Errors
    /// As [`MeshPhase::levels`].
    pub fn levels_mut(&mut self) -> Result<&mut Hierarchy, Missing> {
        if let Self::Levels(hierarchy) = self { Ok(hierarchy) } else { Err(CHECK) }
    }

    /// The levels, to keep.
    ///
    /// # Errors
    /// As [`MeshPhase::levels`].
    pub fn into_levels(self) -> Result<Hierarchy, Missing> {
        if let Self::Levels(hierarchy) = self { Ok(hierarchy) } else { Err(CHECK) }
    }

    /// Takes what the file says, for the check.
    ///
    /// # Errors
    /// If nothing was imported, or that is checked already; it then stays.
    pub fn take_imported(&mut self) -> Result<Dataset, Missing> {
        match std::mem::take(self) {
            Self::Imported(dataset) => Ok(dataset),
            other => {
                *self = other;
                Err(IMPORT)
            }
        }
    }

    /// Makes levels of a checked mesh: `first` makes the coarsest.
    pub(super) fn begin_levels(&mut self, first: impl FnOnce(TetMesh) -> Hierarchy) {
        *self = match std::mem::take(self) {
            Self::Checked(mesh) => Self::Levels(first(mesh)),
            other => other,
        };
    }
}
