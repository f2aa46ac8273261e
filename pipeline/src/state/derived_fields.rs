//! Fields that are computed from a mesh, on their way into a file.

use octruss_meshio::{Dataset, Field};

/// Fields computed from a mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DerivedFields {
    /// On its vertices.
    pub points: Vec<Field>,
    /// On its tets.
    pub cells: Vec<Field>,
}

impl DerivedFields {
    /// Puts others behind these.
    #[must_use]
    pub fn and(mut self, others: Self) -> Self {
        self.points.extend(others.points);
        self.cells.extend(others.cells);
        self
    }

    /// Adds them, in place of fields of their names that came with the input.
    pub fn add_to(&self, dataset: &mut Dataset) {
        let Dataset { point_fields, cell_fields, .. } = dataset;
        for (fields, derived) in [(point_fields, &self.points), (cell_fields, &self.cells)] {
            fields.retain(|field| !has(derived, field));
            fields.extend(derived.iter().cloned());
        }
    }

    /// A remark about each field whose place they take.
    pub fn replaced(&self, point_fields: &[Field], cell_fields: &[Field]) -> Vec<String> {
        let points = self.points.iter().filter(|field| has(point_fields, field));
        let cells = self.cells.iter().filter(|field| has(cell_fields, field));
        let note = |field: &Field| {
            let name = &field.name;
            format!(
                "the mesh file has a field `{name}`, which was left out: the name is that of a field computed here; rename it to keep it"
            )
        };
        points.chain(cells).map(note).collect()
    }
}

fn has(fields: &[Field], wanted: &Field) -> bool {
    fields.iter().any(|field| field.name == wanted.name)
}
