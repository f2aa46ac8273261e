//! From the sections of a file to a [`Dataset`].

use octruss_mesh::{Group, RawMesh};

use super::data::FieldStep;
use super::elements::Elements;
use super::nodes::Nodes;
use crate::dataset::{Dataset, Field};
use crate::notes;

/// What the sections of a file say.
#[derive(Default)]
pub struct Sections {
    /// `$PhysicalNames`.
    pub groups: Vec<Group>,
    /// `$NodeData`, one a section.
    pub point_data: Vec<FieldStep>,
    /// `$ElementData`, one a section.
    pub cell_data: Vec<FieldStep>,
    /// `$ElementNodeData`, one a section.
    pub corner_data: Vec<FieldStep>,
    /// Remarks on what was passed over.
    pub notes: Vec<String>,
}

/// Puts nodes, elements and the other sections together.
pub fn dataset(nodes: Nodes, elements: Elements, sections: Sections) -> Dataset {
    let mut notes = sections.notes;
    note_groups(&elements, &sections.groups, &mut notes);
    let point_fields = fields(sections.point_data, "nodes", &mut notes);
    let cell_fields = fields(sections.cell_data, "tets", &mut notes);
    let corner_fields = fields(sections.corner_data, "tets", &mut notes);
    let mesh = RawMesh {
        points: nodes.points,
        tets: elements.tets,
        regions: elements.regions,
        triangles: elements.triangles,
        edges: elements.edges,
        vertices: elements.vertices,
        groups: sections.groups,
        features: None,
    };
    let mut dataset = Dataset { mesh, point_fields, cell_fields, corner_fields, notes };
    elements.mid_side.drop_from(&mut dataset);
    dataset
}

fn note_groups(elements: &Elements, groups: &[Group], notes: &mut Vec<String>) {
    let several = elements.tets_in_several_groups;
    if several > 0 {
        notes.push(notes::several_regions(several));
    }
    let grouped = elements.regions.iter().any(|&region| region != 0)
        || !elements.triangles.is_empty()
        || !elements.edges.is_empty()
        || !elements.vertices.is_empty();
    if !groups.is_empty() && !grouped {
        notes.push(notes::unused_groups(groups.len()));
    }
}

/// The fields by unique names: later time steps of a name get the step added.
fn fields(data: Vec<FieldStep>, owners: &str, notes: &mut Vec<String>) -> Vec<Field> {
    let mut fields: Vec<Field> = Vec::with_capacity(data.len());
    for FieldStep { mut field, step, owners: count, missing } in data {
        let taken = |name: &str, fields: &[Field]| fields.iter().any(|other| other.name == name);
        if taken(&field.name, &fields) {
            field.name = format!("{} (step {step})", field.name);
        }
        while taken(&field.name, &fields) {
            field.name.push('\'');
        }
        if missing > 0 {
            notes.push(notes::missing_values(&field.name, missing, count, owners));
        }
        fields.push(field);
    }
    fields
}
