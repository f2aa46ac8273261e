//! What problems with one unknown a vertex have in common.

use std::time::Instant;

use octruss_fem::Error as SolverError;
use octruss_fem::{Dofs, Scalar, System};
use octruss_mesh::{Hierarchy, RawMesh};
use octruss_meshio::Field;

use super::Context;
use super::groups::on_surfaces;
use super::multigrid::{Discrete, blank_outside, range};
use super::solve::{Outcome, Solve, assembled, solve_in_turn};
use crate::error::Error;
use crate::recipe::ValueOrVector;

/// Solves the problem that a stage describes on the finest mesh.
///
/// # Errors
/// A surface or region that the mesh does not have; whatever the solver reports.
pub(super) fn solve(
    options: &Solve,
    hierarchy: &Hierarchy,
    discretise: impl FnOnce(&Solve, &Hierarchy, &Context) -> Result<Discrete<f64>, Error>,
    context: &Context,
) -> Result<Outcome, Error> {
    let (discrete, assembly_seconds) =
        assembled(options, context, || discretise(options, hierarchy, context))?;
    let expand = |x: &[f64]| {
        let mut solution = discrete.finest().expand(x)?;
        blank_outside(&mut solution, &hierarchy.finest().mesh, f64::NAN);
        let range = range(solution.iter().copied());
        Ok((solution, range))
    };
    let (solution, solves) = solve_in_turn(options, hierarchy, &discrete, expand, context)?;
    let point_fields = vec![Field::scalar("solution", solution)];
    Ok(Outcome { solves, assembly_seconds, point_fields, ..Outcome::default() })
}

/// The system on the finest level and the unknowns of all; `system` assembles on a
/// level.
///
/// # Errors
/// Whatever the solver reports.
pub(super) fn assemble_levels(
    options: &Solve,
    hierarchy: &Hierarchy,
    fixed: &[(i32, Scalar)],
    system: impl Fn(usize) -> Result<System, SolverError>,
) -> Result<Discrete<f64>, SolverError> {
    let finest = hierarchy.transfers();
    let (mut levels, mut coarse_matrices, mut coarse_seconds) = (Vec::new(), Vec::new(), 0.0);
    for level in 0..finest {
        levels.push(Dofs::new(&hierarchy.levels()[level].mesh, fixed)?.into());
        if options.reassembles() {
            let start = Instant::now();
            coarse_matrices.push(system(level)?.matrix);
            coarse_seconds += start.elapsed().as_secs_f64();
        }
    }
    let System { matrix, rhs, dofs } = system(finest)?;
    levels.push(dofs.into());
    let coarsest = options
        .coarsest_solution(&levels, || system(0).map(|system| (system.matrix, system.rhs)))?;
    Ok(Discrete { matrix, rhs, levels, coarse_matrices, coarse_seconds, coarsest })
}

/// The prescribed values of surfaces. That every entry gives one is checked when the
/// config is read.
///
/// # Errors
/// A surface that the mesh does not have.
pub(super) fn fixed_values(
    options: &Solve,
    mesh: &RawMesh,
    context: &Context,
) -> Result<Vec<(i32, Scalar)>, Error> {
    let value = |given: &Option<ValueOrVector>| match given {
        Some(ValueOrVector::One(value)) => value.to_scalar(),
        _ => Scalar::from(0.0),
    };
    let fixed = options.fixed.iter().map(|entry| entry.get_ref());
    on_surfaces(fixed.map(|at| (&at.surface, value(&at.value))), mesh, context)
}
