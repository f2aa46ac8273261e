//! From what a file says to a mesh that can be worked with.

use octruss_mesh::{CheckOptions, Checked};
use octruss_meshio::Field;
use serde::Deserialize;

use super::context::Context;
use super::corner_fields::CornerFields;
use crate::error::Error;
use crate::report::{CheckReport, FindingReport};
use crate::state::{InputNumbers, MeshPhase, State};

/// Refuses a mesh that refining and solving cannot live with; drops vertices
/// that nothing uses.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Check {
    /// Turn inverted tets over instead of refusing them.
    pub reorient: bool,
}

impl Check {
    pub(super) fn run(&self, state: &mut State, context: &Context) -> Result<CheckReport, Error> {
        let dataset = context.needed(state.mesh.take_imported())?;
        let options = CheckOptions { reorient: self.reorient };
        let corners = CornerFields::new(&dataset);
        state.input_numbers = InputNumbers::of(&dataset);
        let Checked { mesh, findings, kept_vertices } = octruss_mesh::check(dataset.mesh, &options)
            .map_err(|source| Error::Unsound { path: state.path.clone(), source })?;
        state.sided_fields = corners.sided(&mesh, kept_vertices.as_deref());
        // What was computed from this mesh would not hold on a finer one.
        let data = |fields: Vec<Field>| fields.into_iter().filter(|field| !field.derived);
        let point_fields = data(dataset.point_fields);
        state.point_fields = match kept_vertices {
            Some(kept) => {
                state.input_numbers.keep_vertices(&kept);
                let kept = || kept.iter().map(|&v| v as usize);
                point_fields.map(|field| field.subset(kept())).collect()
            }
            None => point_fields.collect(),
        };
        state.cell_fields = data(dataset.cell_fields).collect();
        let report = CheckReport {
            vertices: mesh.points().len(),
            tets: mesh.tets().len(),
            findings: findings.iter().map(FindingReport::from).collect(),
        };
        state.mesh = MeshPhase::Checked(mesh);
        Ok(report)
    }
}
