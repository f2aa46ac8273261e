//! Solving on the finest mesh, once with each prolongation.

use std::num::NonZeroU8;
use std::time::Instant;

use octruss_mesh::{FeatureOptions, Hierarchy, Scheme};
use octruss_meshio::Field;
use octruss_solver::{Poisson, System, assemble};
use serde::{Deserialize, Serialize};
use toml::Spanned;

use super::Context;
use super::multigrid::{SolveFigures, solve_with};
use super::poisson::poisson;
use crate::amount::short;
use crate::error::Error;
use crate::recipe::{Named, PerRegion, Positive, SchemeName, Value};
use crate::state::State;

/// Solves a problem on the finest mesh by conjugate gradients with a multigrid
/// V-cycle over all levels, in turn with each prolongation. The first solution
/// becomes the field `solution` (of a second such stage `solution-2`), with NaN
/// at vertices of free-standing triangles and edges, which no tet uses.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Solve {
    /// Which equation.
    pub problem: Problem,
    /// k > 0, one number or one a region; 1 where none is given.
    pub coefficient: PerRegion,
    /// f per unit of volume, one number or one a region; 0 where none is given.
    pub source: PerRegion,
    /// Values of u on surfaces; on a common edge the last listed counts.
    pub fixed: Vec<OnSurface>,
    /// k ∂u/∂n on surfaces, n outward: what flows in per unit of area.
    pub flux: Vec<OnSurface>,
    /// Which matrices prolong: `linear`, or those of the scheme that refined all levels.
    pub prolongation: Vec<SchemeName>,
    /// Stop at this residual, relative to the right-hand side.
    pub tolerance: Positive,
    /// Give up after so many iterations.
    pub max_iterations: usize,
    /// The degree of the Chebyshev smoother.
    pub smoothing_degree: NonZeroU8,
    /// Smoothing sweeps before, and again after, each coarse correction.
    pub sweeps: NonZeroU8,
}

/// The equations that can be solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Problem {
    /// −div(k grad u) = f.
    Poisson,
}

/// A number on a named surface.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct OnSurface {
    /// The surface group.
    pub surface: Spanned<String>,
    /// The number there.
    pub value: Value,
}

/// All solves of a stage.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolveReport {
    /// Which equation.
    pub problem: Problem,
    /// The time to assemble it, once for all solves.
    pub assembly_seconds: f64,
    /// One a prolongation.
    pub solves: Vec<SolveFigures>,
}

impl Default for Solve {
    fn default() -> Self {
        let options = octruss_solver::SolveOptions::default();
        Self {
            problem: Problem::Poisson,
            coefficient: PerRegion::Uniform(Value(1.0)),
            source: PerRegion::Uniform(Value(0.0)),
            fixed: Vec::new(),
            flux: Vec::new(),
            prolongation: vec![Named(Scheme::BoxSpline), Named(Scheme::Linear)],
            tolerance: Positive(options.tolerance),
            max_iterations: options.max_iterations,
            smoothing_degree: NonZeroU8::MIN.saturating_add(2),
            sweeps: NonZeroU8::MIN,
        }
    }
}

impl Solve {
    pub(super) fn run(&self, state: &mut State, context: &Context) -> Result<SolveReport, Error> {
        state.levels(&FeatureOptions::default());
        let hierarchy = state.hierarchy.as_ref().ok_or_else(|| context.order("check"))?;
        self.check_prolongations(&state.schemes, context)?;
        let problem = poisson(self, hierarchy.finest().raw(), context)?;
        let steps = self.prolongation.len() + 1;
        let start = Instant::now();
        let system = context.progress.step(1, steps, "assembly", || {
            let system = assemble_finest(hierarchy, &problem)
                .map_err(|source| context.solver("assembly", source))?;
            let unknowns = format!("{} unknowns", short(system.dofs.unknowns()));
            Ok::<_, Error>((system, unknowns))
        })?;
        let assembly_seconds = start.elapsed().as_secs_f64();
        let mut solves = Vec::new();
        let mut first_solution = None;
        for (index, &Named(scheme)) in self.prolongation.iter().enumerate() {
            let what = format!("{} prolongation", scheme.name());
            let (solution, figures) = context.progress.step(index + 2, steps, &what, || {
                let solved = solve_with(self, scheme, hierarchy, (&problem, &system), context)
                    .map_err(|source| context.solver(&what, source))?;
                let result = solved.1.result();
                Ok::<_, Error>((solved, result))
            })?;
            first_solution.get_or_insert(solution);
            solves.push(figures);
        }
        if let Some(solution) = first_solution {
            let name = context.progress.label.replace("solve", "solution");
            state.point_fields.retain(|field| field.name != name);
            state.point_fields.push(Field::scalar(name, solution));
        }
        Ok(SolveReport { problem: self.problem, assembly_seconds, solves })
    }

    /// Linear interpolation fits any levels; the matrices of another scheme only
    /// those that they made.
    fn check_prolongations(&self, schemes: &[Scheme], context: &Context) -> Result<(), Error> {
        let list = &self.prolongation;
        if list.is_empty() || (1..list.len()).any(|index| list[..index].contains(&list[index])) {
            let message = "`prolongation` must name at least one scheme, and none twice";
            return Err(context.request(message.into()));
        }
        for &Named(prolongation) in list.iter().filter(|name| name.0 != Scheme::Linear) {
            let other = schemes.iter().position(|&scheme| scheme != prolongation);
            if let Some(refinement) = other {
                let (level, name) = (refinement + 1, prolongation.name());
                return Err(context.request(format!(
                    "prolongation `{name}` needs levels that it refined, but level {level} is \
                     refined by `{}`: set scheme = \"{name}\" or prolongation = [\"linear\"]",
                    schemes[refinement].name()
                )));
            }
        }
        Ok(())
    }
}

fn assemble_finest(
    hierarchy: &Hierarchy,
    problem: &Poisson,
) -> Result<System, octruss_solver::Error> {
    let finest = hierarchy.meshes.len() - 1;
    assemble(&hierarchy.meshes[finest], &hierarchy.topologies[finest], problem)
}

impl SolveReport {
    pub(super) fn summary(&self) -> String {
        let iterations: Vec<String> = self
            .solves
            .iter()
            .map(|solve| format!("{} in {} iterations", solve.prolongation, solve.iterations))
            .collect();
        iterations.join(", ")
    }
}
