//! From a scheme's matrix to the vertices of the fine mesh.

use crate::core::control_points::ControlPoints;
use crate::core::edge_length::mean_edge_length;
use crate::core::raw_mesh::RawMesh;
use crate::refinement::affine_correction::{Geometry, corrected};
use crate::refinement::guard_report::GuardReport;
use crate::refinement::interpolation_report::InterpolationReport;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::subdivide::guard::Guard;
use crate::subdivide::passing_through::pass::{Passed, Step};

/// The vertices of the fine mesh, and how they came about.
pub(super) struct Moved {
    pub points: Vec<[f64; 3]>,
    pub matrix: SubdivisionMatrix,
    pub guard: Option<GuardReport>,
    pub control_points: Option<ControlPoints>,
    pub interpolation: Option<InterpolationReport>,
}

impl Moved {
    /// By the scheme's rows, pulled back by the guard.
    pub fn by_rows(coarse: &RawMesh, mut matrix: SubdivisionMatrix, guard: Option<Guard>) -> Self {
        let mut points = matrix.apply(&coarse.points);
        let guard = guard.map(|guard| guard.apply(&mut matrix, &mut points));
        Self { points, matrix, guard, control_points: None, interpolation: None }
    }

    /// Towards the limit of control points; the rows follow.
    pub fn through_the_input(step: &Step) -> Self {
        let Passed { points, control_points, report, pulls } = step.pass();
        let coarse = &step.coarse.points;
        let length = mean_edge_length(coarse, step.topology);
        let geometry = Geometry::new((coarse, step.topology), &points, length);
        let (matrix, _) = corrected(step.matrix, &geometry);
        let guard = pulls.map(|pulls| pulls.report);
        let control_points = Some(control_points);
        Self { points, matrix, guard, control_points, interpolation: Some(report) }
    }
}
