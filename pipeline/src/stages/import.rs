//! Reading a mesh file.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::Context;
use crate::amount::short;
use crate::error::Error;
use crate::mesh_phase::MeshPhase;
use crate::state::State;

/// Reads a mesh file: Gmsh `.msh`, VTK `.vtu` or `.vtk`, Medit `.mesh`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Import {
    /// The file, relative to the config.
    pub path: PathBuf,
}

/// What was read.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ImportReport {
    /// The file.
    pub path: PathBuf,
    /// Points in the file.
    pub vertices: usize,
    /// Tets in the file.
    pub tets: usize,
    /// What the reader left out or changed.
    pub notes: Vec<String>,
}

impl Import {
    pub(super) fn run(&self, state: &mut State, context: &Context) -> Result<ImportReport, Error> {
        let path = context.input_folder.join(&self.path);
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

impl ImportReport {
    pub(super) fn summary(&self) -> String {
        let (vertices, tets) = (short(self.vertices), short(self.tets));
        format!("{}: {vertices} vertices, {tets} tets", self.path.display())
    }
}
