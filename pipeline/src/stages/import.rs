//! Reading a mesh file.

use std::path::PathBuf;

use serde::Deserialize;

use super::context::Context;
use crate::error::Error;
use crate::report::ImportReport;
use crate::state::{MeshPhase, State};

/// Reads a mesh file: Gmsh `.msh`, VTK `.vtu` or `.vtk`, Medit `.mesh`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Import {
    /// The file, relative to the config.
    pub path: PathBuf,
}

impl Import {
    pub(super) fn run(&self, state: &mut State, context: &Context) -> Result<ImportReport, Error> {
        let path = context.work.input_folder.join(&self.path);
        let dataset = octruss_meshio::read(&path)?;
        context.remark(&dataset.notes);
        let report = ImportReport {
            path: path.clone(),
            vertices: dataset.mesh.points.len(),
            tets: dataset.mesh.tets.len(),
            notes: dataset.notes.clone(),
        };
        *state = State { path, mesh: MeshPhase::Imported(dataset), ..State::default() };
        Ok(report)
    }
}
