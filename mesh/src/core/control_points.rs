//! What a smooth surface through given vertices is the limit of.

use crate::core::curve_ends::CurveEnds;

/// Points whose limit under an approximating scheme is a given boundary: solved for
/// once, on the mesh that is refined first, and refined with it by the scheme's rules.
///
/// They are not vertices of the mesh: it keeps its own, and a new boundary vertex goes
/// towards the limit of its control point. Where a vertex is not listed, its position
/// counts.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ControlPoints {
    /// The vertices that have a control point, ascending: those of curve and surface
    /// strata; with [`Placement::AtLimit`] all.
    pub vertices: Vec<u32>,
    /// The control point of each, in mesh units.
    pub positions: Vec<[f64; 3]>,
    /// How new vertices are placed, decided when the points were solved for.
    pub placement: Placement,
    /// The rule at the ends of curves that they are refined by.
    pub curve_ends: CurveEnds,
}

/// Where a new boundary vertex is put, given its limit x* and the midpoint m of its edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Placement {
    /// m, moved towards x* along the mean normal of the facets at the edge; on a crease
    /// at right angles to it. Flat faces are then split linearly. New interior vertices
    /// follow their neighbours, old ones stay.
    #[default]
    AlongNormals,
    /// x* itself; vertices of the solid follow the scheme's rules, applied to control
    /// points of their own. For walls so thin that the other placement would turn tets
    /// inside out.
    AtLimit,
}

impl ControlPoints {
    /// The control points of all vertices of a mesh with these positions.
    ///
    /// Listed vertices that the mesh does not have are left out.
    pub fn of_all(&self, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let mut all = points.to_vec();
        for (&vertex, &position) in self.vertices.iter().zip(&self.positions) {
            if let Some(place) = all.get_mut(vertex as usize) {
                *place = position;
            }
        }
        all
    }
}
