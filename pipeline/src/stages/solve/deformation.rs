//! Solving for the deformation of an elastic body.

use octruss_mesh::Hierarchy;

use super::body::Body;
use super::elasticity::{ElasticityKeys, problem};
use super::free_parts::free_parts;
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
    let mut notes = locked_supports(&problem, hierarchy)
        .map_err(|source| context.solver("supports", source))?;
    context.remark(&notes);
    let (discrete, assembly_seconds) = discretise(options, hierarchy, &problem, context)?;
    let length = |u: &[f64; 3]| u.iter().map(|u| u * u).sum::<f64>().sqrt();
    let (mut solution, solves) = solve_in_turn(options, &discrete, length, context)?;
    blank_outside(&mut solution.values, &finest.mesh, [f64::NAN; 3]);
    let constraints = &discrete.constraints;
    let is_free = discrete.free.is_some();
    let body = Body { keys, finest, problem: &problem, constraints, is_free };
    let (figures, point_fields, cell_fields) =
        body.describe(solution).map_err(|source| context.solver("stresses and forces", source))?;
    let (free_parts, mut more) = free_parts(&discrete);
    more.extend(imbalance_note(figures.forces.imbalance));
    context.remark(&more);
    notes.extend(more);
    let body = Some(figures);
    Ok(Outcome { solves, assembly_seconds, notes, free_parts, point_fields, cell_fields, body })
}

/// Forces that balance worse than this, relative to their size, are told: what supports carry
/// is known no better.
const IMBALANCE: f64 = 1e-4;

/// What to say about forces that do not balance.
fn imbalance_note(imbalance: f64) -> Option<String> {
    // Written so that NaN is told.
    let is_balanced = imbalance <= IMBALANCE;
    (!is_balanced).then(|| {
        format!(
            "the forces on the body balance to {imbalance:.1e} of their size only: reactions and \
             stresses are no better; a smaller `tolerance` helps, unless stiffnesses or prescribed \
             displacements differ by so many powers of ten that digits are lost"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forces_that_do_not_balance_are_told() {
        assert_eq!(imbalance_note(1e-9), None);
        assert!(imbalance_note(0.75).unwrap().contains("7.5e-1 of their size"));
        assert!(imbalance_note(f64::NAN).is_some());
    }
}
