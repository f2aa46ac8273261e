//! A biharmonic problem from the names that a config uses.

use octruss_fem::{Biharmonic, Scalar, assemble_biharmonic};
use octruss_mesh::{Hierarchy, Level};

use super::Context;
use super::groups::by_region;
use super::multigrid::Discrete;
use super::scalar::{assemble_levels, fixed_values};
use super::solve::Solve;
use crate::error::Error;
use crate::recipe::Value;

/// The problem that a stage describes, on the finest mesh.
///
/// # Errors
/// A surface or region that the mesh does not have; whatever the solver reports.
pub(crate) fn discretise(
    options: &Solve,
    hierarchy: &Hierarchy,
    context: &Context,
) -> Result<Discrete<f64>, Error> {
    let mesh = hierarchy.finest().mesh.raw();
    let zero = Scalar::from(0.0);
    let problem = Biharmonic {
        source: by_region(&options.source, Value::to_scalar, zero, mesh, context)?,
        fixed: fixed_values(options, mesh, context)?,
    };
    let system = |level: usize| {
        let Level { mesh, topology, .. } = &*hierarchy.levels()[level];
        assemble_biharmonic(mesh, topology, &problem)
    };
    assemble_levels(options, hierarchy, &problem.fixed, system)
        .map_err(|source| context.solver("assembly", source))
}
