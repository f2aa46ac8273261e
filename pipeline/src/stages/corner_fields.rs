//! Fields at the corners of tets, on their way through the check of a mesh.

use octruss_mesh::{Sides, TetMesh};
use octruss_meshio::{Dataset, Field, Values};

use crate::state::{SidedFields, floats};

/// Fields at the corners of tets, with the tets as they were listed.
pub(super) struct CornerFields {
    fields: Vec<Field>,
    tets: Vec<[u32; 4]>,
}

impl CornerFields {
    pub(super) fn new(dataset: &Dataset) -> Self {
        let fields = dataset.corner_fields.clone();
        let tets = if fields.is_empty() { Vec::new() } else { dataset.mesh.tets.clone() };
        Self { fields, tets }
    }

    /// The fields as those of sides: a region has one value a vertex. `kept` has the
    /// old number of each vertex, where checking left some out.
    pub(super) fn sided(self, mesh: &TetMesh, kept: Option<&[u32]>) -> SidedFields {
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
