//! What a vertex carries: one number, or the three of a displacement.

use crate::boundary::constraints::Constraints;
use crate::boundary::dofs::Dofs;
use crate::boundary::level_unknowns::LevelUnknowns;
use crate::boundary::motions::Frame;
use crate::error::Error;
use octruss_solver::{NearNullSpace, SystemEntry};

/// A matrix entry, for what a vertex carries, and how that is constrained: numbers by
/// [`Dofs`], displacements (blocks) by [`Constraints`].
pub trait Unknown: SystemEntry {
    /// Which unknowns are free, and what the others are.
    type Constraints;

    /// The unknowns as a level of the multigrid sees them.
    fn level(constraints: &Self::Constraints) -> LevelUnknowns<Self>;

    /// What vertices with these (position, value) do, in words, if it takes no energy.
    fn motion(moved: &[([f64; 3], Self::Nodal)]) -> Option<String>;

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

    fn motion(moved: &[([f64; 3], f64)]) -> Option<String> {
        let mean = moved.iter().map(|(_, value)| value).sum::<f64>() / moved.len().max(1) as f64;
        let is_constant = moved.iter().all(|(_, value)| (value - mean).abs() < 0.1 * mean.abs());
        is_constant.then(|| "a constant may be added to their values".into())
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

    fn motion(moved: &[([f64; 3], [f64; 3])]) -> Option<String> {
        let frame = Frame::around(moved.iter().map(|(position, _)| *position), || [0.0; 3]);
        frame.nearest_mode(moved).map(|mode| mode.to_string())
    }

    fn near_null_space(positions: Vec<[f64; 3]>) -> NearNullSpace {
        NearNullSpace::RigidMotions(positions)
    }

    fn expand(constraints: &Constraints, x: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, Error> {
        constraints.expand(x)
    }
}
