//! The stage `solve`.

use octruss_fem::{Options, Prolongations};
use octruss_mesh::{FeatureOptions, Scheme};
use octruss_meshio::Field;
use serde::Deserialize;

use super::problem::Problem;
use super::{biharmonic, elasticity, in_turn, poisson};
use crate::error::Error;
use crate::options::Several;
use crate::report::{BodyFigures, SolveFigures, SolveStageReport};
use crate::stages::context::Context;
use crate::stages::contradiction::Contradiction;
use crate::state::State;

/// Solves a problem on the finest mesh by conjugate gradients with a multigrid
/// cycle over all levels, or by cycles alone, in turn with each prolongation. The
/// first solution becomes the field `solution` (of a second such stage `solution-2`),
/// with NaN at vertices of free-standing triangles and edges, which no tet uses. Of
/// elasticity these are `displacement`, and `strain`, `stress` and `von-mises` on
/// tets and recovered at vertices; there one of each material, where there are
/// several, as `stress-REGION`, NaN at vertices without it. Components of tensors
/// come in the order of VTK: xx, yy, zz, xy, yz, xz.
///
/// In a config the keys of the problem and of the options stand beside these.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Solve {
    /// Which equation, with its data.
    pub problem: Problem,
    /// Which matrices prolong, in turn: those of a scheme or `smoothed-linear`.
    pub prolongation: Several<Prolongations>,
    /// How it is solved.
    pub options: Options,
    /// Measure bytes and bandwidth of each kernel after solving.
    pub account: bool,
}

/// What solving a problem brings.
#[derive(Default)]
pub(super) struct Outcome {
    pub(super) solves: Vec<SolveFigures>,
    pub(super) assembly_seconds: f64,
    pub(super) body: Option<BodyFigures>,
    pub(super) point_fields: Vec<Field>,
    pub(super) cell_fields: Vec<Field>,
}

impl Default for Solve {
    fn default() -> Self {
        Self {
            problem: Problem::default(),
            prolongation: [Scheme::BoxSpline.into(), Scheme::Linear.into()].into(),
            options: Options::default(),
            account: false,
        }
    }
}

impl Solve {
    pub(in crate::stages) fn run(
        &self,
        state: &mut State,
        context: &Context,
    ) -> Result<SolveStageReport, Error> {
        let hierarchy = context.needed(state.levels(&FeatureOptions::default()))?;
        let mesh = hierarchy.finest().mesh.raw();
        let outcome = match &self.problem {
            Problem::Poisson(keys) => {
                let problem = poisson::problem(keys, mesh, context)?;
                in_turn::scalar(self, hierarchy, &problem, context)?
            }
            Problem::Biharmonic(keys) => {
                let problem = biharmonic::problem(keys, mesh, context)?;
                in_turn::scalar(self, hierarchy, &problem, context)?
            }
            Problem::Elasticity(keys) => elasticity::solve(self, keys, hierarchy, context)?,
        };
        let Outcome { solves, assembly_seconds, body, point_fields, cell_fields } = outcome;
        let number = context.stage.label.strip_prefix("solve").unwrap_or_default();
        add_fields(&mut state.point_fields, point_fields, number);
        add_fields(&mut state.cell_fields, cell_fields, number);
        let problem = self.problem.equation().name().into();
        Ok(SolveStageReport { problem, assembly_seconds, solves, body })
    }

    /// What in the options does not go together, if anything.
    pub(in crate::stages) fn contradiction(&self) -> Option<Contradiction> {
        if let Some((key, message)) = self.options.contradiction() {
            return Some(Contradiction::of_key(key, message));
        }
        if let Problem::Elasticity(keys) = &self.problem
            && keys.material.is_none()
        {
            let message = "problem = \"elasticity\" needs `material`, such as \
                { young = 210e3, poisson = 0.3 }";
            return Some(Contradiction::of_stage(message.into()));
        }
        let equation = self.problem.equation();
        self.problem.fixed().iter().find_map(|fixed| {
            let message = fixed.get_ref().contradiction(equation)?;
            Some(Contradiction::at(fixed.span(), message))
        })
    }

    /// The options of a solve with these prolongations.
    pub(crate) fn with(&self, prolongation: Prolongations) -> Options {
        Options { prolongation, ..self.options }
    }
}

/// Adds fields under their names and the number of the stage, in place of older
/// ones called so.
fn add_fields(all: &mut Vec<Field>, new: Vec<Field>, number: &str) {
    for mut field in new {
        field.name += number;
        all.retain(|old| old.name != field.name);
        all.push(field);
    }
}
