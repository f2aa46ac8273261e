//! Chang's own test (thesis, section 4.9): the solution of a coarse level is carried up
//! by a scheme and by linear interpolation, and both are compared with the solution
//! of the finer level.

use octruss_base::choice::Choice;
use octruss_fem::{Discretisation, Error, Options, Unknown};
use octruss_mesh::Scheme;
use octruss_solver::{Nodal, dot, kernels, norm};

use super::attempt::attempt;
use super::carried_solution::CarriedSolution;
use crate::options::Geometry;
use crate::stages::Context;

/// Carries the solution of the level below the finest up by each scheme. What is
/// prescribed on the finer level does not count. Nothing comes of a solution that is
/// zero or that was not reached.
///
/// # Errors
/// Whatever the solver reports.
pub(super) fn carry<E: Unknown>(
    options: &Options,
    schemes: &[Scheme],
    geometry: Geometry,
    [coarse, fine]: [&Discretisation<E>; 2],
    context: &Context,
) -> Result<Vec<CarriedSolution>, Error> {
    let transfer = coarse.hierarchy.transfers();
    let solutions = (solution(options, fine, context)?, solution(options, coarse, context)?);
    let (Some(computed), Some(coarse_solution)) = solutions else { return Ok(Vec::new()) };
    let coarse_values = coarse.finest().expand(&coarse_solution);
    let energy = |v: &[E::Nodal]| {
        let mut image = v.to_vec();
        kernels::product(&fine.matrix, v, &mut image);
        dot(v, &image).sqrt()
    };
    let carried = |&scheme: &Scheme| {
        let made = fine.hierarchy.prolongation(transfer, scheme);
        let values = made.matrix.apply_field(Nodal::flat(&coarse_values), E::SIZE);
        let free = fine.finest().dofs.free().iter().zip(&computed);
        let mut difference: Vec<E::Nodal> = free
            .map(|(&vertex, x)| {
                let value = |k| values[E::SIZE * vertex as usize + k];
                let carried: E::Nodal = Nodal::from_fn(value);
                carried.minus(*x)
            })
            .collect();
        fine.project(&mut difference);
        CarriedSolution {
            geometry: geometry.name().into(),
            level: transfer + 1,
            prolongation: scheme.name().into(),
            difference: norm(&difference) / norm(&computed),
            energy_difference: energy(&difference) / energy(&computed),
        }
    };
    Ok(schemes.iter().map(carried).collect())
}

/// The solution of a level to the tolerance of the stage; none if that is not reached,
/// or the solution is zero.
fn solution<E: Unknown>(
    options: &Options,
    discrete: &Discretisation<E>,
    context: &Context,
) -> Result<Option<Vec<E::Nodal>>, Error> {
    let mut multigrid = discrete.solver(options)?.multigrid;
    let solved = attempt(options, (discrete, &discrete.rhs), &mut multigrid, context)?;
    Ok(solved.map(|(x, _)| x).filter(|x| norm(x) > 0.0))
}
