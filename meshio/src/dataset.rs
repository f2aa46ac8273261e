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
    /// Fields with four tuples a tet, one for each of its corners in their order,
    /// that may differ from tet to tet. VTK's formats have no room for them.
    pub corner_fields: Vec<Field>,
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
    /// Whether the values were computed from the mesh, as a quality is, and so say
    /// nothing about another one: refining leaves such a field out. VTU files keep
    /// this flag.
    pub derived: bool,
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
    /// A field of data, not derived from the mesh.
    pub fn new(name: impl Into<String>, components: usize, values: Values) -> Self {
        Self { name: name.into(), components, values, derived: false }
    }

    /// A scalar field of floating-point values.
    pub fn scalar(name: impl Into<String>, values: Vec<f64>) -> Self {
        Self::new(name, 1, Values::Float(values))
    }

    /// A scalar field of values computed from the mesh.
    pub fn derived(name: impl Into<String>, values: Values) -> Self {
        Self { derived: true, ..Self::new(name, 1, values) }
    }

    /// How many tuples the field has.
    pub fn tuples(&self) -> usize {
        self.values.len() / self.components.max(1)
    }

    /// The field on the tuples `kept` alone, in their order.
    ///
    /// # Panics
    /// If there is no such tuple.
    pub fn subset(&self, kept: impl Iterator<Item = usize>) -> Self {
        fn pick<T: Copy>(
            values: &[T],
            components: usize,
            kept: impl Iterator<Item = usize>,
        ) -> Vec<T> {
            kept.flat_map(|t| &values[t * components..(t + 1) * components]).copied().collect()
        }
        let values = match &self.values {
            Values::Float(values) => Values::Float(pick(values, self.components, kept)),
            Values::Integer(values) => Values::Integer(pick(values, self.components, kept)),
        };
        Self { values, name: self.name.clone(), ..*self }
    }
}

impl Dataset {
    /// Whether all lists have the lengths that belong together, and names tell
    /// fields apart; writers ask before they write. The error says which do not.
    pub(crate) fn check_lengths(&self) -> Result<(), String> {
        let mesh = &self.mesh;
        for (what, tags, simplices) in [
            ("regions for the tets", mesh.regions.len(), mesh.tets.len()),
            ("tags for the triangles", mesh.triangles.tags.len(), mesh.triangles.len()),
            ("tags for the edges", mesh.edges.tags.len(), mesh.edges.len()),
            ("tags for the vertices", mesh.vertices.tags.len(), mesh.vertices.len()),
        ] {
            if tags != simplices {
                return Err(format!("there are {tags} {what}, which are {simplices}"));
            }
        }
        let states = mesh.features.as_ref().map_or(0, |features| features.cell_states.len());
        if states != 0 && states != mesh.tets.len() {
            return Err(format!("there are {states} states of cells for {} tets", mesh.tets.len()));
        }
        check_fields(&self.point_fields, mesh.points.len(), "points")?;
        check_fields(&self.cell_fields, mesh.tets.len(), "tets")?;
        check_fields(&self.corner_fields, 4 * mesh.tets.len(), "corners of tets")
    }
}

fn check_fields(fields: &[Field], tuples: usize, of: &str) -> Result<(), String> {
    let mut names: Vec<&str> = fields.iter().map(|field| field.name.as_str()).collect();
    names.sort_unstable();
    if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(format!("two fields of the {of} are called `{}`; rename one", pair[0]));
    }
    for Field { name, components, values, .. } in fields {
        if *components == 0 || Some(values.len()) != components.checked_mul(tuples) {
            return Err(format!(
                "the field `{name}` has {} values, not {components} for each of {tuples} {of}",
                values.len()
            ));
        }
    }
    Ok(())
}

/// A field may not have the name of an array that the file has anyway.
pub(crate) fn refuse_name(fields: &[Field], taken: &str) -> Result<(), String> {
    if fields.iter().any(|field| field.name == taken) {
        return Err(format!("a field is called `{taken}`, which has its own meaning; rename it"));
    }
    Ok(())
}
