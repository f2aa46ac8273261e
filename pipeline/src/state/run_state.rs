//! What flows between the stages of a run.

use std::path::PathBuf;

use octruss_mesh::{
    FeatureOptions, FeatureReasons, Hierarchy, Level, Overshoot, Renumbering, Step, TetMesh,
    prepare, sort_along_curve,
};
use octruss_meshio::{Dataset, Field, Values};

use super::floats::floats;
use super::input_numbers::InputNumbers;
use super::mesh_phase::{MeshPhase, Missing};
use super::refine_error::RefineError;
use super::sided_fields::SidedFields;

/// What the stages so far have made.
#[derive(Debug, Default)]
pub struct State {
    /// The mesh file.
    pub path: PathBuf,
    /// The mesh: as imported, checked, or in levels.
    pub mesh: MeshPhase,
    /// Where the vertices and tets of the checked mesh, or of the coarsest level, are
    /// in the file.
    pub input_numbers: InputNumbers,
    /// Why the curves and points of the coarsest level are what they are.
    pub feature_reasons: FeatureReasons,
    /// Fields on the vertices of the finest mesh.
    pub point_fields: Vec<Field>,
    /// Fields on the tets of the finest mesh.
    pub cell_fields: Vec<Field>,
    /// Fields that may jump between regions, if there are any.
    pub sided_fields: SidedFields,
    /// The files that stages `write` wrote.
    pub written: Vec<PathBuf>,
}

impl State {
    /// The levels; the checked mesh becomes the only one if there are none. It is
    /// readied as `options` say, in whose numbering, and then sorted along a
    /// space-filling curve. A mesh that carries features has been through both.
    ///
    /// # Errors
    /// If nothing is checked.
    pub fn levels(&mut self, options: &FeatureOptions) -> Result<&Hierarchy, Missing> {
        if let MeshPhase::Checked(_) = &self.mesh {
            let mut phase = std::mem::take(&mut self.mesh);
            phase.begin_levels(|mesh| self.coarsest(mesh, options));
            self.mesh = phase;
        }
        self.mesh.levels()
    }

    /// Makes the checked mesh the coarsest level.
    fn coarsest(&mut self, mesh: TetMesh, options: &FeatureOptions) -> Hierarchy {
        let (mesh, options) = match mesh.features() {
            Some(_) => (mesh, None),
            None => {
                let (mesh, from) = sort_along_curve(prepare(mesh, options));
                self.renumber(&mesh, &from);
                let extra = options.extra.renumbered(&from.new_vertices());
                (mesh, Some(FeatureOptions { extra, ..options.clone() }))
            }
        };
        let hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
        let Level { mesh, topology, .. } = hierarchy.coarsest();
        self.feature_reasons = FeatureReasons::new(mesh, topology, options.as_ref());
        hierarchy
    }

    /// Takes the fields along to the new numbers of the mesh.
    fn renumber(&mut self, mesh: &TetMesh, from: &Renumbering) {
        let follow = |fields: &mut Vec<Field>, from: &[u32]| {
            let from = || from.iter().map(|&old| old as usize);
            fields.iter_mut().for_each(|field| *field = field.subset(from()));
        };
        follow(&mut self.point_fields, &from.vertices);
        follow(&mut self.cell_fields, &from.tets);
        self.sided_fields.renumber(mesh, from);
        self.input_numbers.renumber(from);
    }

    /// Adds a level, onto which the fields are carried; returns how many values
    /// were clamped.
    ///
    /// # Errors
    /// As [`MeshPhase::levels`] and [`Hierarchy::subdivide`]; everything then stays as it
    /// was.
    pub fn refine(&mut self, step: Step, overshoot: Overshoot) -> Result<usize, RefineError> {
        let hierarchy = self.mesh.levels_mut()?;
        hierarchy.subdivide(step)?;
        let refinement = hierarchy.refinement(hierarchy.transfers() - 1);
        let mut clamped = 0;
        for field in &mut self.point_fields {
            let (values, components) = (floats(field), field.components);
            let carried = refinement.carry_point_field(&values, components, overshoot);
            field.values = Values::Float(carried.values);
            clamped += carried.clamped;
        }
        clamped += self.sided_fields.refine(hierarchy, overshoot);
        for field in &mut self.cell_fields {
            field.values = match &field.values {
                Values::Float(all) => Values::Float(refinement.inherit(all, field.components)),
                Values::Integer(all) => Values::Integer(refinement.inherit(all, field.components)),
            };
        }
        Ok(clamped)
    }

    /// The finest mesh with its fields and where its vertices and tets are in the
    /// file, or what was imported if nothing was checked.
    pub fn into_dataset(self) -> Dataset {
        let Self { mesh, point_fields, cell_fields, input_numbers, .. } = self;
        let (finest, input_numbers) = match mesh {
            MeshPhase::Nothing => return Dataset::default(),
            MeshPhase::Imported(dataset) => return dataset,
            MeshPhase::Checked(mesh) => (mesh, input_numbers),
            MeshPhase::Levels(levels) => {
                let numbers = input_numbers.refined(levels.refinements());
                (levels.into_finest().mesh, numbers)
            }
        };
        let numbers = input_numbers.fields();
        let notes = numbers.replaced(&point_fields, &cell_fields);
        let mesh = finest.into_raw();
        let mut dataset = Dataset { mesh, point_fields, cell_fields, notes, ..Dataset::default() };
        numbers.add_to(&mut dataset);
        dataset
    }
}
