//! A mesh with its named fields, as a file holds it.

use octruss_mesh::RawMesh;

/// What a file says, unchecked: a mesh, fields on it, and remarks of the reader.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Dataset {
    /// The mesh, unchecked.
    pub mesh: RawMesh,
    /// Fields with one tuple a vertex.
    pub point_fields: Vec<Field>,
    /// Fields with one tuple a tet (never for triangles or edges).
    pub cell_fields: Vec<Field>,
    /// What the reader left out or changed, a sentence each, for the user to read.
    pub notes: Vec<String>,
}

/// A named field: `components` values a tuple, tuple after tuple.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// The name, as files and users spell it.
    pub name: String,
    /// Values a tuple: 1 scalar, 3 vector, 9 tensor.
    pub components: usize,
    /// The values, `components` × tuples of them.
    pub values: Values,
}

/// The values of a field. Narrower types of a file are widened, which loses nothing.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Floating-point values.
    Float(Vec<f64>),
    /// Whole numbers.
    Integer(Vec<i64>),
}

impl Values {
    /// How many values there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Float(values) => values.len(),
            Self::Integer(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Field {
    /// A scalar field of floating-point values.
    pub fn scalar(name: impl Into<String>, values: Vec<f64>) -> Self {
        Self { name: name.into(), components: 1, values: Values::Float(values) }
    }

    /// How many tuples the field has.
    pub fn tuples(&self) -> usize {
        self.values.len() / self.components.max(1)
    }
}
