//! A problem solved with each prolongation in turn.

use std::time::Instant;

use octruss_fem::{Discretisation, Error as FemError, Problem, Solution, Unknown};
use octruss_mesh::{Hierarchy, TetMesh};
use octruss_meshio::{Field, Values};
use octruss_solver::Nodal;

use super::equation::Equation;
use super::free_parts::free_parts;
use super::keys::Solve;
use super::outcome::Outcome;
use super::unfinished::keep;
use crate::amount::short;
use crate::error::Error;
use crate::observer::Event;
use crate::report::SolveFigures;
use crate::stages::context::Context;

/// Solves a problem with one unknown a vertex.
pub(super) fn scalar(
    options: &Solve,
    hierarchy: &Hierarchy,
    problem: &impl Problem<Entry = f64>,
    context: &Context,
) -> Result<Outcome, Error> {
    let (discrete, assembly_seconds) = discretise(options, hierarchy, problem, context)?;
    let magnitude = |u: &f64| *u;
    let (first, solves) = solve_in_turn(options, &discrete, magnitude, context)?;
    let mut solution = first.values;
    blank_outside(&mut solution, &hierarchy.finest().mesh, f64::NAN);
    let point_fields = vec![Field::scalar("solution", solution)];
    let (free_parts, notes) = free_parts(&discrete);
    context.remark(&notes);
    Ok(Outcome { solves, assembly_seconds, notes, free_parts, point_fields, ..Outcome::default() })
}

/// Assembles as the first step of a stage; what came of it, and the seconds.
pub(super) fn discretise<'h, P: Problem>(
    options: &Solve,
    hierarchy: &'h Hierarchy,
    problem: &P,
    context: &Context,
) -> Result<(Discretisation<'h, P::Entry>, f64), Error> {
    let start = Instant::now();
    let steps = options.in_turn().len() + 1;
    let discrete = context.step(1, steps, "assembly", || {
        let discrete = Discretisation::new(hierarchy, problem, &options.options)
            .and_then(|discrete| discrete.check_loaded().map(|()| discrete))
            .map_err(|source| context.solver("assembly", source))?;
        let unknowns = format!("{} unknowns", short(discrete.unknowns()));
        Ok::<_, Error>((discrete, unknowns))
    })?;
    Ok((discrete, start.elapsed().as_secs_f64()))
}

/// Solves with each prolongation: the first solution, and the figures of all, with the range of what `magnitude` makes of values at vertices of tets.
pub(super) fn solve_in_turn<E: Unknown>(
    options: &Solve,
    discrete: &Discretisation<E>,
    magnitude: impl Fn(&E::Nodal) -> f64,
    context: &Context,
) -> Result<(Solution<E>, Vec<SolveFigures>), Error> {
    let all_options = options.in_turn();
    let steps = all_options.len() + 1;
    let (mut first, mut all) = (None, Vec::new());
    for (index, chosen) in all_options.into_iter().enumerate() {
        let prolongations = chosen.prolongation.unwrap_or(discrete.usual_prolongation);
        let what = format!("{prolongations} prolongation");
        let (solution, figures) = context.step(index + 2, steps, &what, || {
            let solve = || {
                let mut solver = discrete.solver(&chosen)?;
                let tell = |iteration: usize, residual: f64| {
                    let note = format!("iteration {iteration}, residual {residual:.1e}");
                    context.tell(Event::Note(note));
                    context.go_on()
                };
                let solution = solver.solve(Some(&tell))?;
                Ok((solver, solution))
            };
            let (mut solver, solution) =
                solve().map_err(|source| failed(source, options, discrete, &what, context))?;
            let inside = is_inside(&discrete.hierarchy.finest().mesh);
            let inside = solution.values.iter().zip(inside).filter(|(_, inside)| *inside);
            let range = range(inside.map(|(value, _)| magnitude(value)));
            let mut figures = SolveFigures::new(&chosen, &solver, &solution, range);
            figures.account = options.account.then(|| solver.multigrid.traffic(REPEATS).into());
            let result = figures.result();
            Ok::<_, Error>(((solution, figures), result))
        })?;
        first.get_or_insert(solution);
        all.push(figures);
    }
    let nothing = || context.request("`prolongation` lists none to solve with".into());
    Ok((first.ok_or_else(nothing)?, all))
}

/// How often each kernel is measured; the median counts.
const REPEATS: usize = 7;

/// What stopped a solve; its best iterate is kept if there is one.
fn failed<E: Unknown>(
    source: FemError,
    options: &Solve,
    discrete: &Discretisation<E>,
    what: &str,
    context: &Context,
) -> Error {
    let Some(at) = source.unfinished() else { return context.solver(what, source) };
    match discrete.expand(&E::Nodal::from_flat(&at.iterate)) {
        Ok(mut values) => {
            let mesh = &discrete.hierarchy.finest().mesh;
            blank_outside(&mut values, mesh, E::Nodal::from_fn(|_| f64::NAN));
            let field = field_of(options.problem.equation(), Nodal::flat(&values));
            keep(field, &source, at.report.clone(), mesh, what, context)
        }
        Err(source) => context.solver(what, source),
    }
}

/// A solution at vertices, from the numbers one after the other.
fn field_of(equation: Equation, numbers: &[f64]) -> Field {
    match equation {
        Equation::Poisson | Equation::Biharmonic => Field::scalar("solution", numbers.to_vec()),
        Equation::Elasticity => Field::new("displacement", 3, Values::Float(numbers.to_vec())),
    }
}

/// The least and the greatest value; NaN is passed over.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, greatest], value| {
        [least.min(value), greatest.max(value)]
    })
}

/// Which vertices a tet uses.
fn is_inside(mesh: &TetMesh) -> Vec<bool> {
    let mut inside = vec![false; mesh.points().len()];
    mesh.tets().as_flattened().iter().for_each(|&v| inside[v as usize] = true);
    inside
}

/// Puts `blank`, NaN, which viewers leave blank, where no tet is and nothing was
/// solved.
pub(super) fn blank_outside<T: Copy>(solution: &mut [T], mesh: &TetMesh, blank: T) {
    for (value, _) in solution.iter_mut().zip(is_inside(mesh)).filter(|(_, inside)| !inside) {
        *value = blank;
    }
}
