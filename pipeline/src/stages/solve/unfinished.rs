//! What is kept of a solve that did not reach its goal.

use octruss_fem::Error as SolverError;
use octruss_mesh::TetMesh;
use octruss_meshio::{Dataset, Field, vtu};
use octruss_solver::SolveReport;

use crate::error::{Error, UnfinishedSolve};
use crate::output::{UNFINISHED, create_folder};
use crate::stages::context::Context;

/// Writes the best iterate as `unfinished.vtu` on the finest mesh; tells where it is
/// and what it reached, or why it could not be written.
pub(super) fn keep(
    field: Field,
    reason: &SolverError,
    report: SolveReport,
    finest: &TetMesh,
    what: &str,
    context: &Context,
) -> Error {
    let file = context.work.output_folder.join(UNFINISHED);
    let iterate =
        Dataset { mesh: finest.raw().clone(), point_fields: vec![field], ..Dataset::default() };
    let written = create_folder(context.work.output_folder)
        .and_then(|()| vtu::write(&file, &iterate).map_err(Error::from));
    if let Err(error) = written {
        return error;
    }
    Error::Unfinished(Box::new(UnfinishedSolve {
        stage: context.stage.label.clone(),
        what: what.into(),
        reason: reason.to_string(),
        iterations: report.iterations,
        relative_residual: report.relative_residual,
        residual_history: report.residual_history,
        file,
    }))
}
