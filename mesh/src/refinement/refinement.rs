//! How a fine mesh came from a coarse one.

use std::ops::Range;

use crate::refinement::ancestry::Ancestry;
use crate::refinement::carry::{Carried, Overshoot, carry_field};
use crate::refinement::guard_report::GuardReport;
use crate::refinement::interpolation_report::InterpolationReport;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::scheme::Scheme;

/// How a fine mesh came from a coarse one, and how what is known of the one goes
/// down to the other, whichever way its tets were split.
///
/// ```
/// use octruss_mesh::{FeatureOptions, Hierarchy, Overshoot, Scheme, shapes};
/// let mut hierarchy = Hierarchy::new(shapes::kuhn_cube(1), &FeatureOptions::default());
/// hierarchy.subdivide(Scheme::Linear)?;
/// let refinement = hierarchy.refinement(0);
/// // One number a tet, and the height of each vertex.
/// let numbers = refinement.inherit(&[0, 1, 2, 3, 4, 5], 1);
/// assert!(refinement.children(2).all(|child| numbers[child as usize] == 2));
/// let height: Vec<f64> = hierarchy.coarsest().mesh.points().iter().map(|p| p[2]).collect();
/// let height = refinement.carry_point_field(&height, 1, Overshoot::Allow).values;
/// assert_eq!(height.len(), hierarchy.finest().mesh.points().len());
/// # Ok::<(), octruss_mesh::SubdivideError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Refinement {
    /// The scheme that made it.
    pub scheme: Scheme,
    /// The scheme's matrix, n_fine × n_coarse: fine positions are matrix ×
    /// coarse positions. Where the step interpolates, and beside mirror planes, its rows are
    /// changed for that as little as possible.
    pub matrix: SubdivisionMatrix,
    /// Where the coarse mesh has mirror planes, the matrix of fields that are alike on both
    /// sides of each, so that their slope across is 0. It reads the images of vertices as
    /// the vertices, and is that of the whole body for such a field, guard and interpolation
    /// included. Positions are no such field; for them rows of [`Self::matrix`] beside the
    /// planes are these, changed as little as possible.
    pub mirrored: Option<SubdivisionMatrix>,
    /// Where each part of the fine mesh lies in the coarse one.
    pub ancestry: Ancestry,
    /// What the guard did, if the step had one.
    pub guard: Option<GuardReport>,
    /// How passing through the vertices of the input went, if the step was to.
    pub interpolation: Option<InterpolationReport>,
}

impl Refinement {
    /// The coarse tet that a fine tet is a part of.
    ///
    /// # Panics
    /// If there is no such fine tet.
    pub fn parent(&self, child: u32) -> u32 {
        self.ancestry.tets.parent(child)
    }

    /// The parts of a coarse tet.
    ///
    /// # Panics
    /// If there is no such coarse tet.
    pub fn children(&self, parent: u32) -> Range<u32> {
        self.ancestry.tets.children(parent)
    }

    /// A field on the tets, `components` values each: every tet has the tuple of
    /// its parent.
    ///
    /// # Panics
    /// If `values` does not have `components` values for each coarse tet.
    pub fn inherit<T>(&self, values: &[T], components: usize) -> Vec<T>
    where
        T: Copy + Default + Send + Sync,
    {
        self.ancestry.tets.inherit(values, components)
    }

    /// The matrix that carries fields: as positions are moved, or as beside mirror planes.
    pub fn field_matrix(&self) -> &SubdivisionMatrix {
        self.mirrored.as_ref().unwrap_or(&self.matrix)
    }

    /// A field on the vertices, `components` values each, carried by
    /// [`Self::field_matrix`].
    ///
    /// Beside mirror planes each component counts as a scalar that is alike on both sides,
    /// for it is not known which fields are vectors of space: the component of a
    /// displacement across a plane, which is turned round there, is carried as if it was
    /// not.
    ///
    /// # Panics
    /// If `values` does not have `components` values for each coarse vertex.
    pub fn carry_point_field(
        &self,
        values: &[f64],
        components: usize,
        overshoot: Overshoot,
    ) -> Carried {
        carry_field(self.field_matrix(), values, components, overshoot)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::raw_mesh::RawMesh;
    use crate::core::topology::Topology;
    use crate::refinement::ancestry::{Ancestor, SplitEdges};
    use crate::refinement::lineage::Lineage;
    use crate::refinement::sided_field::Sides;

    /// Two tets on the face 1 2 3; the edge 0 1 of the first is halved.
    fn coarse() -> RawMesh {
        let mut mesh = RawMesh {
            points: vec![[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0], [4.0; 3]],
            tets: vec![[0, 1, 2, 3], [1, 2, 3, 4]],
            regions: vec![5, 6],
            ..RawMesh::default()
        };
        mesh.triangles.push([0, 1, 2], 1);
        mesh.triangles.push([1, 2, 4], 2);
        mesh.edges.push([4, 3], 3);
        mesh.edges.push([0, 1], 4);
        mesh
    }

    fn bisection() -> (RawMesh, Refinement) {
        let topology = Topology::new(&coarse());
        let matrix = SubdivisionMatrix::from_rows(6, 5, |row, entries| match row {
            5 => [0, 1].into_iter().for_each(|end| entries.add(end, 0.5)),
            _ => entries.add(row as u32, 1.0),
        });
        let ancestry = Ancestry {
            vertices: 5,
            split_edges: SplitEdges::Some(vec![topology.edge_between(0, 1).unwrap()]),
            tets: Lineage::listed(vec![0, 0, 1]),
            triangles: Lineage::listed(vec![0, 0, 1]),
            edges: Lineage::listed(vec![0, 1, 1]),
        };
        let fine = RawMesh {
            points: matrix.apply(&coarse().points),
            tets: vec![[0, 5, 2, 3], [5, 1, 2, 3], [1, 2, 3, 4]],
            regions: ancestry.tets.inherit(&coarse().regions, 1),
            ..RawMesh::default()
        };
        (
            fine,
            Refinement {
                scheme: Scheme::Linear,
                matrix,
                mirrored: None,
                ancestry,
                guard: None,
                interpolation: None,
            },
        )
    }

    #[test]
    fn regions_tags_and_fields_go_down_a_bisection() {
        let (fine, refinement) = bisection();
        assert_eq!(fine.regions, [5, 5, 6]);
        assert_eq!([0, 1, 2].map(|child| refinement.parent(child)), [0, 0, 1]);
        assert_eq!([refinement.children(0), refinement.children(1)], [0..2, 2..3]);
        assert_eq!(refinement.inherit(&[1.0, 2.0, 3.0, 4.0], 2), [1.0, 2.0, 1.0, 2.0, 3.0, 4.0]);
        let Ancestry { triangles, edges, .. } = &refinement.ancestry;
        assert_eq!(triangles.inherit(&coarse().triangles.tags, 1), [1, 1, 2]);
        assert_eq!(edges.inherit(&coarse().edges.tags, 1), [3, 4, 4]);
        let carried = refinement.carry_point_field(&[1.0, 3.0, 0.0, 0.0, 9.0], 1, Overshoot::Clamp);
        assert_eq!(carried, Carried { values: vec![1.0, 3.0, 0.0, 0.0, 9.0, 2.0], clamped: 0 });
    }

    #[test]
    fn each_side_of_an_interface_goes_down_a_bisection() {
        let (fine, refinement) = bisection();
        let mesh = |raw: RawMesh| crate::check(raw, &Default::default()).unwrap().mesh;
        let (coarse, fine) = (mesh(coarse()), mesh(fine));
        let sides = [&coarse, &fine].map(Sides::new);
        let own = |region: i32| f64::from(region);
        let values: Vec<f64> = sides[0].regions().iter().map(|&region| own(region)).collect();
        let step = (&Topology::new(coarse.raw()), &refinement);
        let carried = sides[0].carry(step, &sides[1], &values, 1, Overshoot::Allow).values;
        assert_eq!(carried.len(), 5 + 4);
        assert!(carried.iter().zip(sides[1].regions()).all(|(value, &r)| *value == own(r)));
        assert_eq!(refinement.ancestry.of_vertex(5), Ancestor::Edge(0));
    }
}
