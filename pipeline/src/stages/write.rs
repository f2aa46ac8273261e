//! Files for ParaView.

use std::path::{Path, PathBuf};

use octruss_mesh::quality::mean_ratios;
use octruss_mesh::{RawMesh, TetMesh};
use octruss_meshio::{Dataset, Field, pvd, vtu};
use serde::{Deserialize, Serialize};

use super::Context;
use crate::amount;
use crate::error::Error;
use crate::output::{create_folder, write_with_surfaces};
use crate::state::State;

/// Writes `solution.vtu` (the finest mesh with every field, region and quality
/// a cell) and what else is asked for, each file whole or not at all.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Write {
    /// One `level-N.vtu` a level, 0 the coarsest, and `levels.pvd` that lists them.
    pub levels: bool,
    /// `solution.surfaces.vtu`: the tagged surfaces.
    pub surfaces: bool,
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WriteReport {
    /// Every file, in the order of writing.
    pub files: Vec<PathBuf>,
    /// The size of all together.
    pub bytes: u64,
}

impl Default for Write {
    fn default() -> Self {
        Self { levels: true, surfaces: true }
    }
}

impl Write {
    pub(super) fn run(&self, state: &mut State, context: &Context) -> Result<WriteReport, Error> {
        let finest = state.finest().ok_or_else(|| context.order("check"))?;
        let all_levels: &[TetMesh] = state.hierarchy.as_ref().map_or(&[], |levels| &levels.meshes);
        let levels = if self.levels { all_levels } else { &[] };
        let folder = context.output_folder;
        create_folder(folder)?;
        let steps = levels.len() + 1;
        let mut files = context.progress.step(1, steps, "solution.vtu", || {
            let mut cell_fields = state.cell_fields.clone();
            set_quality(&mut cell_fields, finest.raw());
            let point_fields = state.point_fields.clone();
            let mesh = finest.raw().clone();
            let solution = Dataset { mesh, point_fields, cell_fields, notes: Vec::new() };
            self.write_solution(&folder.join("solution.vtu"), &solution)
        })?;
        let mut entries = Vec::new();
        for (number, mesh) in levels.iter().enumerate() {
            let name = format!("level-{number}.vtu");
            let path = folder.join(&name);
            context.progress.step(number + 2, steps, &name, || write_level(&path, mesh))?;
            files.push(path);
            entries.push((number as f64, name));
        }
        if self.levels {
            let path = folder.join("levels.pvd");
            pvd::write(&path, &entries)?;
            files.push(path);
        }
        let bytes = files.iter().map(|file| size(file)).sum();
        Ok(WriteReport { files, bytes })
    }

    fn write_solution(
        &self,
        path: &Path,
        solution: &Dataset,
    ) -> Result<(Vec<PathBuf>, String), Error> {
        let files = if self.surfaces {
            write_with_surfaces(path, solution)?
        } else {
            vtu::write(path, solution)?;
            vec![path.to_path_buf()]
        };
        let bytes = amount::bytes(files.iter().map(|file| size(file)).sum());
        Ok((files, bytes))
    }
}

fn write_level(path: &Path, mesh: &TetMesh) -> Result<((), String), Error> {
    let mut level = Dataset { mesh: mesh.raw().clone(), ..Dataset::default() };
    set_quality(&mut level.cell_fields, mesh.raw());
    vtu::write(path, &level)?;
    Ok(((), amount::bytes(size(path))))
}

/// Adds the mean ratio η of each tet, in place of a field of that name that
/// came with the input.
fn set_quality(fields: &mut Vec<Field>, mesh: &RawMesh) {
    fields.retain(|field| field.name != "quality");
    fields.push(Field::scalar("quality", mean_ratios(mesh)));
}

fn size(path: &Path) -> u64 {
    std::fs::metadata(path).map_or(0, |file| file.len())
}

impl WriteReport {
    pub(super) fn summary(&self) -> String {
        let folder = self.files.first().and_then(|file| file.parent()).unwrap_or(Path::new(""));
        let (count, bytes) = (self.files.len(), amount::bytes(self.bytes));
        format!("{count} files in {}, {bytes}", folder.display())
    }
}
