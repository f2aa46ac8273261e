//! A Poisson problem from the names that a config uses, and its solution.

use octruss_mesh::{Hierarchy, RawMesh};
use octruss_meshio::Field;
use octruss_solver::{Dofs, Error as SolverError, Poisson, Robin, Scalar, System, assemble};

use super::Context;
use super::groups::{by_region, on_surfaces};
use super::multigrid::{Discrete, blank_outside, range};
use super::solve::{Outcome, Solve, assembled, solve_in_turn};
use crate::error::Error;
use crate::recipe::{Value, ValueOrVector};

/// Solves the problem that a stage describes on the finest mesh.
///
/// # Errors
/// A surface or region that the mesh does not have; whatever the solver reports.
pub(super) fn solve(
    options: &Solve,
    hierarchy: &Hierarchy,
    context: &Context,
) -> Result<Outcome, Error> {
    let problem = problem(options, hierarchy.finest().raw(), context)?;
    let (discrete, assembly_seconds) =
        assembled(options, context, || assemble_levels(options, hierarchy, &problem))?;
    let expand = |x: &[f64]| {
        let mut solution = discrete.finest().expand(x)?;
        blank_outside(&mut solution, hierarchy.finest(), f64::NAN);
        let range = range(solution.iter().copied());
        Ok((solution, range))
    };
    let (solution, solves) = solve_in_turn(options, hierarchy, &discrete, expand, context)?;
    let point_fields = vec![Field::scalar("solution", solution)];
    Ok(Outcome { solves, assembly_seconds, point_fields, ..Outcome::default() })
}

/// The problem that a stage describes, on the finest mesh.
///
/// # Errors
/// As [`solve`], but of assembling alone.
pub(crate) fn discretise(
    options: &Solve,
    hierarchy: &Hierarchy,
    context: &Context,
) -> Result<Discrete<f64>, Error> {
    let problem = problem(options, hierarchy.finest().raw(), context)?;
    assemble_levels(options, hierarchy, &problem)
        .map_err(|source| context.solver("assembly", source))
}

/// The system on the finest level and the unknowns of all.
fn assemble_levels(
    options: &Solve,
    hierarchy: &Hierarchy,
    problem: &Poisson,
) -> Result<Discrete<f64>, SolverError> {
    let finest = hierarchy.meshes.len() - 1;
    let system_of =
        |level: usize| assemble(&hierarchy.meshes[level], &hierarchy.topologies[level], problem);
    let (mut levels, mut coarse_matrices) = (Vec::new(), Vec::new());
    for level in 0..finest {
        levels.push(Dofs::new(&hierarchy.meshes[level], &problem.fixed)?.into());
        if options.reassembles() {
            coarse_matrices.push(system_of(level)?.matrix);
        }
    }
    let System { matrix, rhs, dofs } = system_of(finest)?;
    levels.push(dofs.into());
    let coarsest = options
        .coarsest_solution(&levels, || system_of(0).map(|system| (system.matrix, system.rhs)))?;
    Ok(Discrete { matrix, rhs, levels, coarse_matrices, coarsest })
}

/// The problem that a stage describes, on this mesh.
fn problem(options: &Solve, mesh: &RawMesh, context: &Context) -> Result<Poisson, Error> {
    let scalars = |given, otherwise: f64| {
        by_region(given, Value::to_scalar, Scalar::from(otherwise), mesh, context)
    };
    // That every entry gives one value is checked when the config is read.
    let value = |given: &Option<ValueOrVector>| match given {
        Some(ValueOrVector::One(value)) => value.to_scalar(),
        _ => Scalar::from(0.0),
    };
    let fixed = options.fixed.iter().map(|entry| entry.get_ref());
    Ok(Poisson {
        coefficient: scalars(&options.coefficient, 1.0)?,
        source: scalars(&options.source, 0.0)?,
        fixed: on_surfaces(fixed.map(|at| (&at.surface, value(&at.value))), mesh, context)?,
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
