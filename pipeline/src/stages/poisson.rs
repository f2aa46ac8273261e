//! A Poisson problem from the names that a config uses, and its solution.

use octruss_mesh::{Hierarchy, RawMesh};
use octruss_meshio::Field;
use octruss_solver::{Dofs, Error as SolverError, Poisson, Robin, Scalar, assemble};

use super::Context;
use super::groups::{by_region, on_surfaces};
use super::multigrid::{Discrete, LevelUnknowns, blank_outside, range};
use super::solve::{Outcome, Solve, assembled, solve_in_turn};
use super::transfers::CoarseOperator;
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
        let system = assemble(&hierarchy.meshes[finest], &hierarchy.topologies[finest], &problem)?;
        let coarse = hierarchy.meshes.iter().zip(&hierarchy.topologies).take(finest);
        let (mut dofs, mut coarse_matrices) = (Vec::new(), Vec::new());
        for (mesh, topology) in coarse {
            dofs.push(Dofs::new(mesh, &problem.fixed)?);
            if options.coarse_operator.0 == CoarseOperator::Reassembled {
                coarse_matrices.push(assemble(mesh, topology, &problem)?.matrix);
            }
        }
        dofs.push(system.dofs);
        let level = |dofs| LevelUnknowns { dofs, projectors: Vec::new() };
        let levels = dofs.into_iter().map(level).collect();
        Ok::<_, SolverError>(Discrete {
            matrix: system.matrix,
            rhs: system.rhs,
            levels,
            coarse_matrices,
        })
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
