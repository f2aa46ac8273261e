//! What it took to pass through the vertices of the input.

use crate::core::control_points::Placement;

/// How one step that interpolates went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InterpolationReport {
    /// The iterations that solving for control points took, on curves and on surfaces;
    /// 0 if they came with the mesh.
    pub iterations: [usize; 2],
    /// How far, at most, a component of the limit of these control points is from the
    /// vertex, in mesh units; 0 if they came with the mesh.
    pub residual: f64,
    /// Whether that is at most the 1e-10 of an edge that it was to be; true if they came
    /// with the mesh.
    pub has_converged: bool,
    /// How many rows of the matrix could not be made exact for the positions.
    pub inexact_rows: usize,
    /// How many vertices have a neighbour on their curve or surface whose control point is
    /// moved against theirs by more than the two are apart: the smooth surface through the
    /// triangles there has wiggles. 0 if the control points came with the mesh.
    pub strained: usize,
    /// How new vertices were placed.
    pub placement: Placement,
    /// The largest distance, in mesh units, by which the guard pulled a boundary vertex
    /// from where the limit had put it.
    pub left_to_limit: f64,
}

impl Default for InterpolationReport {
    /// With control points that came with the mesh, and nothing in the way.
    fn default() -> Self {
        Self {
            iterations: [0; 2],
            residual: 0.0,
            has_converged: true,
            inexact_rows: 0,
            strained: 0,
            placement: Placement::default(),
            left_to_limit: 0.0,
        }
    }
}
