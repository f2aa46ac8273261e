//! Files for ParaView.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use octruss_mesh::quality::mean_ratios;
use octruss_mesh::{Hierarchy, Level, Strata, TetMesh};
use octruss_meshio::{Dataset, Field, Values, pvd, vtu};
use serde::Deserialize;

use super::context::Context;
use super::file_names::{FEATURES, LEVELS, SIDES, SOLUTION, of_level};
use super::stale::remove_stale;
use crate::amount;
use crate::error::Error;
use crate::output::{create_folder, write_with_surfaces};
use crate::report::WriteReport;
use crate::state::{DerivedFields, State};

/// Writes `solution.vtu` (the finest mesh with every field, the stratum of each
/// vertex, region and quality a cell, and where both are in the mesh file),
/// `solution.sides.vtu` if there are fields that jump between regions (the finest
/// mesh taken apart where regions meet, with these fields), and what else is asked
/// for, each file whole or not at all. Files with such names that an earlier run left
/// and this one did not write are removed.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Write {
    /// One `level-N.vtu` a level, 0 the coarsest, and `levels.pvd` that lists them.
    pub levels: bool,
    /// `solution.surfaces.vtu`: the tagged surfaces.
    pub surfaces: bool,
    /// `features.vtu`: the curves and fixed points of the coarsest level, with the
    /// reason for each.
    pub features: bool,
}

impl Default for Write {
    fn default() -> Self {
        Self { levels: true, surfaces: true, features: true }
    }
}

impl Write {
    pub(super) fn run(&self, state: &mut State, context: &Context) -> Result<WriteReport, Error> {
        let finest = context.needed(state.mesh.finest())?;
        let all = state.mesh.levels().map_or(&[][..], Hierarchy::levels);
        let levels = if self.levels { all.len() } else { 0 };
        let folder = context.work.output_folder;
        create_folder(folder)?;
        let derived = derived_fields(state, finest, all);
        let notes = derived.replaced(&state.point_fields, &state.cell_fields);
        context.remark(&notes);
        let mut files = context.step(1, levels + 1, SOLUTION, || {
            let mut solution = Dataset {
                mesh: finest.raw().clone(),
                point_fields: state.point_fields.clone(),
                cell_fields: state.cell_fields.clone(),
                ..Dataset::default()
            };
            derived.add_to(&mut solution);
            self.write_solution(&folder.join(SOLUTION), &solution)
        })?;
        files.extend(write_sides(&folder.join(SIDES), state)?);
        if let Some(coarsest) = all.first().filter(|_| self.features) {
            let path = folder.join(FEATURES);
            vtu::write_features(&path, &coarsest.mesh, &state.feature_reasons)?;
            files.push(path);
        }
        let mut entries = Vec::new();
        for (number, level) in all.iter().take(levels).enumerate() {
            let mesh = &level.mesh;
            let name = of_level(number);
            let path = folder.join(&name);
            context.step(number + 2, levels + 1, &name, || {
                if number + 1 == all.len() {
                    return write_level(&path, mesh, &derived);
                }
                write_level(&path, mesh, &derived_fields(state, mesh, &all[..=number]))
            })?;
            files.push(path);
            entries.push((number as f64, name));
        }
        if self.levels {
            let path = folder.join(LEVELS);
            pvd::write(&path, &entries)?;
            files.push(path);
        }
        let bytes = files.iter().map(|file| size(file)).sum();
        // A stage before this one may have written other levels.
        state.written.extend_from_slice(&files);
        let removed = remove_stale(folder, &state.written, &state.path)?;
        Ok(WriteReport { files, bytes, removed, notes })
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

fn write_level(
    path: &Path,
    mesh: &TetMesh,
    derived: &DerivedFields,
) -> Result<((), String), Error> {
    let mut level = Dataset { mesh: mesh.raw().clone(), ..Dataset::default() };
    derived.add_to(&mut level);
    vtu::write(path, &level)?;
    Ok(((), amount::bytes(size(path))))
}

/// Writes the fields that jump on a mesh with one vertex a side, if there are any.
fn write_sides(path: &Path, state: &State) -> Result<Option<PathBuf>, Error> {
    let (Ok(mesh), Some(sides)) = (state.mesh.finest(), &state.sided_fields.sides) else {
        return Ok(None);
    };
    let apart = Dataset {
        mesh: sides.split_mesh(mesh),
        point_fields: state.sided_fields.fields.clone(),
        ..Dataset::default()
    };
    vtu::write(path, &apart)?;
    Ok(Some(path.into()))
}

/// What is computed from a level to look at it: where its vertices and tets are in
/// the mesh file; the dimension of each vertex's stratum (0 fixed, 1 curve, 2
/// surface, 3 solid), if the features are known; the mean ratio η of each tet.
/// `levels` end with that one; there are none before the mesh is one.
fn derived_fields(state: &State, mesh: &TetMesh, levels: &[Arc<Level>]) -> DerivedFields {
    let strata = levels.last().zip(mesh.features());
    let strata = strata.map(|(level, features)| Strata::new(mesh.raw(), &level.topology, features));
    let stratum = strata.map(|strata| {
        let dimensions = strata.vertex_dimensions.into_iter().map(i64::from).collect();
        Field::derived("stratum", Values::Integer(dimensions))
    });
    let quality = Field::derived("quality", Values::Float(mean_ratios(mesh.raw())));
    let looks = DerivedFields { points: stratum.into_iter().collect(), cells: vec![quality] };
    let refinements = levels.iter().filter_map(|level| level.refinement.as_ref());
    looks.and(state.input_numbers.refined(refinements).fields())
}

fn size(path: &Path) -> u64 {
    std::fs::metadata(path).map_or(0, |file| file.len())
}
