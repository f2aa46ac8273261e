//! Solving for the deformation of an elastic body.

use octruss_mesh::Hierarchy;

use super::body::Body;
use super::elasticity::{ElasticityKeys, problem};
use super::in_turn::{blank_outside, discretise, solve_in_turn};
use super::keys::Solve;
use super::locked_supports::locked_supports;
use super::outcome::Outcome;
use crate::error::Error;
use crate::stages::context::Context;

/// Solves the problem that a stage describes on the finest mesh.
///
/// # Errors
/// A surface or region that the mesh does not have, a region without material;
/// whatever the solver reports.
pub(super) fn solve(
    options: &Solve,
    keys: &ElasticityKeys,
    hierarchy: &Hierarchy,
    context: &Context,
) -> Result<Outcome, Error> {
    let finest = hierarchy.finest();
    let problem = problem(keys, finest.mesh.raw(), context)?;
    let notes = locked_supports(&problem, hierarchy)
        .map_err(|source| context.solver("supports", source))?;
    context.remark(&notes);
    let (discrete, assembly_seconds) = discretise(options, hierarchy, &problem, context)?;
    let length = |u: &[f64; 3]| u.iter().map(|u| u * u).sum::<f64>().sqrt();
    let (mut displacement, solves) = solve_in_turn(options, &discrete, length, context)?;
    blank_outside(&mut displacement, &finest.mesh, [f64::NAN; 3]);
    let body = Body { keys, finest, problem: &problem, constraints: &discrete.constraints };
    let (figures, point_fields, cell_fields) = body
        .describe(displacement)
        .map_err(|source| context.solver("stresses and forces", source))?;
    Ok(Outcome { solves, assembly_seconds, point_fields, cell_fields, notes, body: Some(figures) })
}
