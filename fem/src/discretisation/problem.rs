//! What can be discretised.

use crate::assemble::biharmonic::assemble_biharmonic;
use crate::assemble::elasticity::{VectorSystem, assemble_elasticity};
use crate::assemble::poisson::{System, assemble};
use crate::boundary::constraints::Constraints;
use crate::boundary::dofs::Dofs;
use crate::discretisation::unknown::Unknown;
use crate::error::Error;
use crate::free::free_bodies::FreeBodies;
use crate::options::prolongations::Prolongations;
use crate::problem::biharmonic::Biharmonic;
use crate::problem::elasticity::Elasticity;
use crate::problem::poisson::Poisson;
use crate::problem::scalar::Scalar;
use crate::reference::difference::Difference;
use octruss_mesh::{Hierarchy, InterpolationReport, Level, Placement, Refinement, Scheme};
use octruss_solver::{Csr, NearNullSpace};
use std::borrow::Cow;

/// An equation with its data, on any level of a hierarchy.
pub trait Problem {
    /// What a vertex carries.
    type Entry: Unknown;

    /// Which unknowns are free on a level, and what the others are.
    ///
    /// # Errors
    /// As assembling, about what is prescribed.
    fn constraints(&self, level: &Level) -> Result<Constrained<Self>, Error>;

    /// The prolongation that solves it in the least time, as docs/prolongation.md measures.
    fn usual_prolongation(&self, hierarchy: &Hierarchy) -> Prolongations;

    /// What has no energy on unconstrained vertices at these positions, for the levels below
    /// the coarsest mesh.
    fn near_null_space(&self, positions: Vec<[f64; 3]>) -> NearNullSpace {
        Self::Entry::near_null_space(positions)
    }

    /// Matrix and right-hand side on a level.
    ///
    /// # Errors
    /// [`Error`] tells what is wrong with the data of the problem.
    fn assemble(&self, level: &Level) -> Result<Assembled<Self::Entry>, Error>;

    /// What a problem lacks whose right-hand side and prescribed values are all 0, and what to
    /// do, for [`Error::NoLoad`].
    fn missing_load(&self) -> &'static str {
        "all loads and prescribed values are 0; give one that is not"
    }
}

/// The constraints of a problem.
pub type Constrained<P> = <<P as Problem>::Entry as Unknown>::Constraints;

/// A problem on one level.
pub struct Assembled<E: Unknown> {
    /// One row for each free unknown.
    pub matrix: Csr<E>,
    /// The sum of each row, where that is known better than the entries tell: see
    /// [`WithRowSums`](octruss_solver::WithRowSums).
    pub row_sums: Option<Vec<E>>,
    /// One entry for each free unknown.
    pub rhs: Vec<E::Nodal>,
    /// Which these are.
    pub constraints: E::Constraints,
    /// The same for what the solution differs by from a constant or a rigid motion, where
    /// values are prescribed far from zero.
    pub difference: Option<Difference<E::Nodal>>,
    /// The parts that nothing holds, if their loads were balanced: `matrix` is singular.
    pub free: Option<FreeBodies<E::Nodal>>,
}

impl<E: Unknown> Assembled<E> {
    /// The matrix, of free parts with a little on the diagonal: positive definite, for
    /// preconditioners.
    pub(crate) fn regularised(&self) -> Cow<'_, Csr<E>> {
        regularised(&self.matrix, self.free.as_ref())
    }
}

/// A matrix, of free parts with a little on the diagonal.
pub(crate) fn regularised<'m, E: Unknown>(
    matrix: &'m Csr<E>,
    free: Option<&FreeBodies<E::Nodal>>,
) -> Cow<'m, Csr<E>> {
    free.map_or(Cow::Borrowed(matrix), |free| Cow::Owned(free.regularised(matrix)))
}

impl From<System> for Assembled<f64> {
    fn from(System { matrix, row_sums, rhs, dofs, difference, free }: System) -> Self {
        Self { matrix, row_sums, rhs, constraints: dofs, difference, free }
    }
}

impl From<VectorSystem> for Assembled<[[f64; 3]; 3]> {
    fn from(system: VectorSystem) -> Self {
        let VectorSystem { matrix, row_sums, rhs, constraints, difference, free } = system;
        Self { matrix, row_sums: Some(row_sums), rhs, constraints, difference, free }
    }
}

impl Problem for Poisson {
    type Entry = f64;

    fn constraints(&self, level: &Level) -> Result<Dofs, Error> {
        Dofs::new(&level.mesh, &self.fixed)
    }

    /// Linear: wider rows save few iterations and cost more.
    fn usual_prolongation(&self, _: &Hierarchy) -> Prolongations {
        Scheme::Linear.into()
    }

    fn assemble(&self, level: &Level) -> Result<Assembled<f64>, Error> {
        assemble(&level.mesh, &level.topology, self).map(Assembled::from)
    }

    fn missing_load(&self) -> &'static str {
        "source, flux, Robin and prescribed values are all 0; give one that is not"
    }
}

impl Problem for Biharmonic {
    type Entry = f64;

    fn constraints(&self, level: &Level) -> Result<Dofs, Error> {
        Dofs::new(&level.mesh, &self.fixed)
    }

    /// All harmonic functions have no energy inside: too many for aggregates.
    fn near_null_space(&self, _: Vec<[f64; 3]>) -> NearNullSpace {
        NearNullSpace::Unknown
    }

    /// Box splines: linear interpolation loses ground with every level.
    fn usual_prolongation(&self, _: &Hierarchy) -> Prolongations {
        Scheme::BoxSpline.into()
    }

    fn assemble(&self, level: &Level) -> Result<Assembled<f64>, Error> {
        assemble_biharmonic(&level.mesh, &level.topology, self).map(Assembled::from)
    }

    fn missing_load(&self) -> &'static str {
        "the source and all prescribed values are 0; give one that is not"
    }
}

impl Problem for Elasticity {
    type Entry = [[f64; 3]; 3];

    fn constraints(&self, level: &Level) -> Result<Constraints, Error> {
        Constraints::new(&level.mesh, &level.topology, &self.supports)
    }

    /// Box splines where a smooth scheme shaped the body, since linear interpolation does not
    /// reproduce rotations there; linear on flat refinements, where it does, and where only new
    /// boundary vertices left the midpoints of their edges, where it nearly does.
    fn usual_prolongation(&self, hierarchy: &Hierarchy) -> Prolongations {
        let follows_midpoints = |made: &Refinement| {
            let along_normals =
                |report: InterpolationReport| report.placement == Placement::AlongNormals;
            made.scheme == Scheme::Linear || made.interpolation.is_some_and(along_normals)
        };
        let is_nearly_flat = hierarchy.refinements().all(follows_midpoints);
        let scheme = if is_nearly_flat { Scheme::Linear } else { Scheme::BoxSpline };
        scheme.into()
    }

    fn assemble(&self, level: &Level) -> Result<Assembled<[[f64; 3]; 3]>, Error> {
        assemble_elasticity(&level.mesh, &level.topology, self).map(Assembled::from)
    }

    fn missing_load(&self) -> &'static str {
        let massless = self.material.all(|material| material.density.is_zero());
        if massless && !self.gravity.iter().all(Scalar::is_zero) {
            return "gravity acts on mass, and no material has any; give a density";
        }
        "body force, gravity times density, tractions, pressures and prescribed displacements are \
         all 0; give one that is not"
    }
}
