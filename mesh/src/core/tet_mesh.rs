//! A mesh that has passed its check.

use crate::core::raw_mesh::{Features, Group, RawMesh, Tagged};
use crate::core::reference_tet::{corners, six_volumes};

/// Points, ordered and positively oriented tets, a region per tet, tagged
/// triangles, edges and vertices; immutable.
///
/// What holds: every index is in range, every coordinate finite, every tet of
/// positive volume, every vertex used by some simplex, no tet twice, no face on
/// more than two tets. Made by [`crate::check()`] or by refining another.
#[derive(Debug, Clone, PartialEq)]
pub struct TetMesh {
    raw: RawMesh,
}

impl TetMesh {
    /// Wraps data that satisfy the invariants by construction.
    pub(crate) fn trusted(raw: RawMesh) -> Self {
        debug_assert_eq!(raw.tets.len(), raw.regions.len());
        Self { raw }
    }

    /// Vertex positions, in mesh units.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.raw.points
    }

    /// Vertex numbers of each tet, positively oriented; the order marks a pair
    /// of opposite edges.
    pub fn tets(&self) -> &[[u32; 4]] {
        &self.raw.tets
    }

    /// The region id of each tet, 0 for none.
    pub fn regions(&self) -> &[i32] {
        &self.raw.regions
    }

    /// Tagged triangles: faces of tets or standing free.
    pub fn triangles(&self) -> &Tagged<3> {
        &self.raw.triangles
    }

    /// Tagged edges: edges of tets or standing free.
    pub fn edges(&self) -> &Tagged<2> {
        &self.raw.edges
    }

    /// Tagged vertices.
    pub fn vertices(&self) -> &Tagged<1> {
        &self.raw.vertices
    }

    /// Names of regions, surfaces, curves and points.
    pub fn groups(&self) -> &[Group] {
        &self.raw.groups
    }

    /// Creases and corners, if they were found already.
    pub fn features(&self) -> Option<&Features> {
        self.raw.features.as_ref()
    }

    /// The data, for writers and for questions about groups.
    pub fn raw(&self) -> &RawMesh {
        &self.raw
    }

    /// The data, given away.
    pub fn into_raw(self) -> RawMesh {
        self.raw
    }

    /// The positions of a tet's four vertices.
    #[inline]
    pub fn corners(&self, tet: usize) -> [[f64; 3]; 4] {
        corners(&self.raw.points, self.raw.tets[tet])
    }

    /// The volume of one tet, in cubed mesh units; positive.
    #[inline]
    pub fn volume(&self, tet: usize) -> f64 {
        six_volumes(self.corners(tet)) / 6.0
    }
}
