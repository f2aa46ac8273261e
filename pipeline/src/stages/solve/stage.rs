//! The stage `solve`.

use octruss_base::choice::Choice;
use octruss_mesh::FeatureOptions;
use octruss_meshio::Field;

use super::keys::Solve;
use super::outcome::Outcome;
use super::problem_keys::ProblemKeys;
use super::{biharmonic, deformation, in_turn, poisson};
use crate::error::Error;
use crate::report::SolveStageReport;
use crate::stages::context::Context;
use crate::state::State;

impl Solve {
    pub(in crate::stages) fn run(
        &self,
        state: &mut State,
        context: &Context,
    ) -> Result<SolveStageReport, Error> {
        let hierarchy = context.needed(state.levels(&FeatureOptions::default()))?;
        let mesh = hierarchy.finest().mesh.raw();
        let outcome = match &self.problem {
            ProblemKeys::Poisson(keys) => {
                let problem = poisson::problem(keys, mesh, context)?;
                in_turn::scalar(self, hierarchy, &problem, context)?
            }
            ProblemKeys::Biharmonic(keys) => {
                let problem = biharmonic::problem(keys, mesh, context)?;
                in_turn::scalar(self, hierarchy, &problem, context)?
            }
            ProblemKeys::Elasticity(keys) => deformation::solve(self, keys, hierarchy, context)?,
        };
        let Outcome {
            solves,
            assembly_seconds,
            notes,
            free_parts,
            body,
            point_fields,
            cell_fields,
        } = outcome;
        let number = context.stage.label.strip_prefix("solve").unwrap_or_default();
        add_fields(&mut state.point_fields, point_fields, number);
        add_fields(&mut state.cell_fields, cell_fields, number);
        let problem = self.problem.equation().name().into();
        Ok(SolveStageReport { problem, assembly_seconds, notes, solves, free_parts, body })
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
