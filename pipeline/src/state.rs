//! What flows between the stages of a run.

use std::path::PathBuf;

use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, Step, SubdivideError, TetMesh};
use octruss_meshio::{Dataset, Field, Values};

/// What the stages so far have made.
#[derive(Debug, Default)]
pub struct State {
    /// The mesh file.
    pub path: PathBuf,
    /// What the file says, until it is checked.
    pub dataset: Option<Dataset>,
    /// The checked mesh, until it is the coarsest level.
    pub mesh: Option<TetMesh>,
    /// The levels, coarsest first.
    pub hierarchy: Option<Hierarchy>,
    /// The scheme of each refinement.
    pub schemes: Vec<Scheme>,
    /// Fields on the vertices of the finest mesh.
    pub point_fields: Vec<Field>,
    /// Fields on the tets of the finest mesh.
    pub cell_fields: Vec<Field>,
}

impl State {
    /// The finest mesh, once checked.
    pub fn finest(&self) -> Option<&TetMesh> {
        self.hierarchy.as_ref().map(Hierarchy::finest).or(self.mesh.as_ref())
    }

    /// The levels; the checked mesh becomes the only one if there are none.
    pub fn levels(&mut self, options: &FeatureOptions) -> Option<&mut Hierarchy> {
        if let Some(mesh) = self.mesh.take() {
            self.hierarchy = Some(Hierarchy::new(mesh, options));
        }
        self.hierarchy.as_mut()
    }

    /// Adds a level, onto which the fields are carried. Without levels nothing
    /// happens.
    ///
    /// # Errors
    /// As [`Hierarchy::subdivide`]; everything then stays as it was.
    pub fn refine(&mut self, step: Step) -> Result<(), SubdivideError> {
        let Some(hierarchy) = &mut self.hierarchy else { return Ok(()) };
        hierarchy.subdivide(step)?;
        self.schemes.push(step.scheme);
        let matrix = &hierarchy.refinements[hierarchy.refinements.len() - 1].matrix;
        for field in &mut self.point_fields {
            // Means of whole numbers are not whole.
            let coarse = match &field.values {
                Values::Float(values) => matrix.apply_field(values, field.components),
                Values::Integer(values) => {
                    let values: Vec<f64> = values.iter().map(|&value| value as f64).collect();
                    matrix.apply_field(&values, field.components)
                }
            };
            field.values = Values::Float(coarse);
        }
        for field in &mut self.cell_fields {
            field.values = match &field.values {
                Values::Float(values) => Values::Float(to_children(values, field.components)),
                Values::Integer(values) => Values::Integer(to_children(values, field.components)),
            };
        }
        Ok(())
    }

    /// The finest mesh with its fields, or what was imported if nothing was checked.
    pub fn into_dataset(self) -> Dataset {
        let Self { dataset, mesh, hierarchy, point_fields, cell_fields, .. } = self;
        let finest = hierarchy.and_then(|mut levels| levels.meshes.pop()).or(mesh);
        match finest {
            Some(mesh) => {
                let mesh = mesh.into_raw();
                Dataset { mesh, point_fields, cell_fields, notes: Vec::new() }
            }
            None => dataset.unwrap_or_default(),
        }
    }
}

/// Each tet's tuple, once for each of its eight children.
fn to_children<T: Copy>(values: &[T], components: usize) -> Vec<T> {
    values.chunks(components.max(1)).flat_map(|tuple| tuple.repeat(8)).collect()
}
