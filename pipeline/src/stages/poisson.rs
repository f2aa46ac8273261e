//! A Poisson problem from the names that a config uses, and its solution.

use octruss_mesh::{Hierarchy, RawMesh};
use octruss_meshio::Field;
use octruss_solver::{
    Dofs, Error as SolverError, LevelUnknowns, Poisson, Robin, Scalar, System, assemble,
};

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
    let (discrete, assembly_seconds) = assembled(options, context, || {
        let finest = hierarchy.meshes.len() - 1;
        let system_of = |level: usize| {
            assemble(&hierarchy.meshes[level], &hierarchy.topologies[level], &problem)
        };
        let System { matrix, rhs, dofs: own } = system_of(finest)?;
        let coarse = hierarchy.meshes[..finest].iter();
        let mut dofs: Vec<Dofs> =
            coarse.map(|mesh| Dofs::new(mesh, &problem.fixed)).collect::<Result<_, _>>()?;
        dofs.push(own);
        let levels: Vec<LevelUnknowns<f64>> = dofs.into_iter().map(LevelUnknowns::from).collect();
        let coarsest = options.coarsest_solution(&levels, || {
            system_of(0).map(|system| (system.matrix, system.rhs))
        })?;
        Ok::<_, SolverError>(Discrete { matrix, rhs, levels, coarsest })
    })?;
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
