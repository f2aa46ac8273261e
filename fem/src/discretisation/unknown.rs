//! What a vertex carries: one number, or the three of a displacement.

use crate::boundary::constraints::Constraints;
use crate::boundary::dofs::Dofs;
use crate::boundary::level_unknowns::LevelUnknowns;
use crate::error::Error;
use octruss_solver::{NearNullSpace, SystemEntry};

/// A matrix entry, for what a vertex carries, and how that is constrained: numbers by
/// [`Dofs`], displacements (blocks) by [`Constraints`].
pub trait Unknown: SystemEntry {
    /// Which unknowns are free, and what the others are.
    type Constraints;

    /// The unknowns as a level of the multigrid sees them.
    fn level(constraints: &Self::Constraints) -> LevelUnknowns<Self>;

    /// What has no energy on unconstrained vertices at these positions.
    fn near_null_space(positions: Vec<[f64; 3]>) -> NearNullSpace;

    /// A value for each vertex from the unknowns.
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless there is one `x` for each unknown.
    fn expand(
        constraints: &Self::Constraints,
        x: &[Self::Nodal],
    ) -> Result<Vec<Self::Nodal>, Error>;
}

impl Unknown for f64 {
    type Constraints = Dofs;

    fn level(constraints: &Dofs) -> LevelUnknowns<Self> {
        constraints.clone().into()
    }

    fn near_null_space(_: Vec<[f64; 3]>) -> NearNullSpace {
        NearNullSpace::Constants
    }

    fn expand(constraints: &Dofs, x: &[f64]) -> Result<Vec<f64>, Error> {
        constraints.expand(x)
    }
}

impl Unknown for [[f64; 3]; 3] {
    type Constraints = Constraints;

    fn level(constraints: &Constraints) -> LevelUnknowns<Self> {
        constraints.into()
    }

    fn near_null_space(positions: Vec<[f64; 3]>) -> NearNullSpace {
        NearNullSpace::RigidMotions(positions)
    }

    fn expand(constraints: &Constraints, x: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, Error> {
        constraints.expand(x)
    }
}
