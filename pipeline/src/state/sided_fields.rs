//! Fields that may jump between regions.

use octruss_mesh::{Hierarchy, Overshoot, Renumbering, Sides, TetMesh};
use octruss_meshio::{Field, Values};

use super::floats::floats;

/// Fields with a tuple for each side of a vertex of the finest mesh.
#[derive(Debug, Default)]
pub struct SidedFields {
    /// The sides; kept once there is a field.
    pub sides: Option<Sides>,
    /// The fields.
    pub fields: Vec<Field>,
}

impl SidedFields {
    /// Takes the fields along to the new numbers of the mesh.
    pub(super) fn renumber(&mut self, mesh: &TetMesh, from: &Renumbering) {
        let Some(old) = &self.sides else { return };
        let new = Sides::new(mesh);
        let old = |(&v, &region): (&u32, &i32)| {
            old.find(from.vertices[v as usize], region).expect("the same regions touch a vertex")
        };
        let order: Vec<usize> = new.vertices().iter().zip(new.regions()).map(old).collect();
        for field in &mut self.fields {
            *field = field.subset(order.iter().copied());
        }
        self.sides = Some(new);
    }

    /// Carries the fields onto the level that was added last; returns how many
    /// values were clamped.
    pub(super) fn refine(&mut self, hierarchy: &Hierarchy, overshoot: Overshoot) -> usize {
        let Some(coarse) = &self.sides else { return 0 };
        let fine = Sides::new(&hierarchy.finest().mesh);
        let transfer = hierarchy.transfers() - 1;
        let step = (&hierarchy.levels()[transfer].topology, hierarchy.refinement(transfer));
        let mut clamped = 0;
        for field in &mut self.fields {
            let carried = coarse.carry(step, &fine, &floats(field), field.components, overshoot);
            field.values = Values::Float(carried.values);
            clamped += carried.clamped;
        }
        self.sides = Some(fine);
        clamped
    }
}
