//! A Poisson problem from the names that a config uses.

use octruss_fem::{Poisson, Robin, Scalar, assemble};
use octruss_mesh::{Hierarchy, Level, RawMesh};

use super::Context;
use super::groups::{by_region, on_surfaces};
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
    let problem = problem(options, hierarchy.finest().mesh.raw(), context)?;
    let system = |level: usize| {
        let Level { mesh, topology, .. } = &*hierarchy.levels()[level];
        assemble(mesh, topology, &problem)
    };
    assemble_levels(options, hierarchy, &problem.fixed, system)
        .map_err(|source| context.solver("assembly", source))
}

/// The problem that a stage describes, on this mesh.
fn problem(options: &Solve, mesh: &RawMesh, context: &Context) -> Result<Poisson, Error> {
    let scalars = |given, otherwise: f64| {
        by_region(given, Value::to_scalar, Scalar::from(otherwise), mesh, context)
    };
    Ok(Poisson {
        coefficient: scalars(&options.coefficient, 1.0)?,
        source: scalars(&options.source, 0.0)?,
        fixed: fixed_values(options, mesh, context)?,
        flux: on_surfaces(
            options.flux.iter().map(|at| (&at.surface, at.value.to_scalar())),
            mesh,
            context,
        )?,
        robin: on_surfaces(
            options.robin.iter().map(|at| {
                let coefficient = at.coefficient.to_scalar();
                (&at.surface, Robin { coefficient, value: at.value.to_scalar() })
            }),
            mesh,
            context,
        )?,
    })
}
