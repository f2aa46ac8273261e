//! From what a file says to a mesh that can be worked with.

use octruss_mesh::{CheckOptions, Checked, Finding, Sides, TetMesh};
use octruss_meshio::{Dataset, Field, Values};
use serde::{Deserialize, Serialize};

use super::Context;
use crate::describe::FindingReport;
use crate::error::Error;
use crate::state::{SidedFields, State, floats};

/// Refuses a mesh that refining and solving cannot live with; drops vertices
/// that nothing uses.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Check {
    /// Turn inverted tets over instead of refusing them.
    pub reorient: bool,
}

/// What was found; nothing of it stopped the run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckReport {
    /// Vertices kept.
    pub vertices: usize,
    /// Tets, all of positive volume.
    pub tets: usize,
    /// Repaired faults and remarks.
    pub findings: Vec<FindingReport>,
    #[serde(skip)]
    messages: Vec<String>,
}

impl Check {
    pub(super) fn run(&self, state: &mut State, context: &Context) -> Result<CheckReport, Error> {
        let dataset = state.dataset.take().ok_or_else(|| context.order("import"))?;
        let options = CheckOptions { reorient: self.reorient };
        let listed = Listed::new(&dataset);
        let Checked { mesh, findings, kept_vertices } = octruss_mesh::check(dataset.mesh, &options)
            .map_err(|source| Error::Unsound { path: state.path.clone(), source })?;
        // What was computed from this mesh would not hold on a finer one.
        state.sided_fields = listed.sided(&mesh, kept_vertices.as_deref());
        let data = |fields: Vec<Field>| fields.into_iter().filter(|field| !field.derived);
        let point_fields = data(dataset.point_fields);
        state.point_fields = match kept_vertices {
            Some(kept) => point_fields.map(|field| subset(&field, &kept)).collect(),
            None => point_fields.collect(),
        };
        state.cell_fields = data(dataset.cell_fields).collect();
        let report = CheckReport {
            vertices: mesh.points().len(),
            tets: mesh.tets().len(),
            findings: findings.iter().map(FindingReport::from).collect(),
            messages: findings.iter().map(Finding::to_string).collect(),
        };
        state.mesh = Some(mesh);
        Ok(report)
    }
}

impl CheckReport {
    pub(super) fn summary(&self) -> String {
        if self.messages.is_empty() { "sound".into() } else { self.messages.join("\n  ") }
    }
}

/// Fields at the corners of tets, with the tets as they were listed.
struct Listed {
    fields: Vec<Field>,
    tets: Vec<[u32; 4]>,
}

impl Listed {
    fn new(dataset: &Dataset) -> Self {
        let fields = dataset.corner_fields.clone();
        let tets = if fields.is_empty() { Vec::new() } else { dataset.mesh.tets.clone() };
        Self { fields, tets }
    }

    /// The fields as those of sides: a region has one value a vertex.
    fn sided(self, mesh: &TetMesh, kept: Option<&[u32]>) -> SidedFields {
        if self.fields.is_empty() {
            return SidedFields::default();
        }
        let sides = Sides::new(mesh);
        let field = |field: Field| {
            let values = self.in_order_of(mesh, kept, &floats(&field), field.components);
            let values = sides.from_corners(mesh, &values, field.components);
            Field { values: Values::Float(values), ..field }
        };
        let fields = self.fields.iter().cloned().map(field).collect();
        SidedFields { sides: Some(sides), fields }
    }

    /// The tuples in the order of the checked tets' corners, which may have been
    /// turned over and renumbered.
    fn in_order_of(
        &self,
        mesh: &TetMesh,
        kept: Option<&[u32]>,
        values: &[f64],
        components: usize,
    ) -> Vec<f64> {
        let corner = |tet: usize, v: u32| {
            let old = kept.map_or(v, |kept| kept[v as usize]);
            let listed = self.tets[tet].iter().position(|&w| w == old);
            4 * tet + listed.expect("checking keeps the vertices of tets")
        };
        let tets = mesh.tets().iter().enumerate();
        tets.flat_map(|(t, tet)| tet.map(|v| corner(t, v)))
            .flat_map(|corner| &values[components * corner..][..components])
            .copied()
            .collect()
    }
}

/// The tuples of a field that belong to the vertices kept.
fn subset(field: &Field, kept: &[u32]) -> Field {
    fn pick<T: Copy>(values: &[T], components: usize, kept: &[u32]) -> Vec<T> {
        let tuple = |&v: &u32| &values[v as usize * components..][..components];
        kept.iter().flat_map(tuple).copied().collect()
    }
    let values = match &field.values {
        Values::Float(values) => Values::Float(pick(values, field.components, kept)),
        Values::Integer(values) => Values::Integer(pick(values, field.components, kept)),
    };
    Field { values, ..field.clone() }
}
