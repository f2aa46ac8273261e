//! How the vertices of a fine mesh come about.

use crate::core::control_points::ControlPoints;
use crate::core::edge_length::mean_edge_length;
use crate::core::mirrors::Unfolded;
use crate::core::raw_mesh::RawMesh;
use crate::core::topology::Topology;
use crate::refinement::affine_correction::{Geometry, corrected};
use crate::refinement::folded::folded;
use crate::refinement::guard_report::GuardReport;
use crate::refinement::interpolation_report::InterpolationReport;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::subdivide::guard::Guard;
use crate::subdivide::passing_through::pass::{Passed, Step as Pass};

/// The vertices of the fine mesh, the rows that lead there, and how both were found.
pub(super) struct Moved {
    pub points: Vec<[f64; 3]>,
    /// Its columns are unfolded vertices, until it is made one on the mesh.
    pub matrix: SubdivisionMatrix,
    /// The matrix of fields, where the mesh has mirror planes.
    pub mirrored: Option<SubdivisionMatrix>,
    pub guard: Option<GuardReport>,
    pub control_points: Option<ControlPoints>,
    pub interpolation: Option<InterpolationReport>,
}

impl Moved {
    /// By the scheme's rows, pulled back by the guard.
    pub fn by_rows(coarse: &Unfolded, mut matrix: SubdivisionMatrix, guard: Option<Guard>) -> Self {
        let mut points = matrix.apply(&coarse.mesh.points);
        let guard = guard.map(|guard| guard.apply(&mut matrix, &mut points));
        let (mirrored, control_points, interpolation) = (None, None, None);
        Self { points, matrix, mirrored, guard, control_points, interpolation }
    }

    /// Towards the limit of control points; the rows follow.
    pub fn to_the_limit(pass: &Pass) -> Self {
        let Passed { points, control_points, mut report, pulls } = pass.pass();
        let coarse = pass.coarse;
        let length = mean_edge_length(&coarse.mesh.points, &coarse.topology);
        let geometry = Geometry::new(coarse, &points, length);
        let (matrix, rows) = corrected(pass.matrix, &geometry);
        report.inexact_rows = rows.left;
        Self {
            points,
            matrix,
            mirrored: None,
            guard: pulls.map(|pulls| pulls.report),
            control_points: Some(control_points),
            interpolation: pass.interpolates.then_some(report),
        }
    }

    /// With matrices whose columns are the vertices of the mesh itself: folded rows for
    /// fields, and these corrected for positions.
    pub fn on_the_mesh(
        mut self,
        (coarse, topology): (&RawMesh, &Topology),
        unfolded: &Unfolded,
    ) -> Self {
        if !unfolded.has_mirrors() {
            return self;
        }
        unfolded.keep_in_planes(&mut self.points);
        let mirrored = folded(self.matrix, unfolded);
        let whole = Unfolded::whole(coarse, topology);
        let length = mean_edge_length(&coarse.points, topology);
        let (matrix, _) = corrected(&mirrored, &Geometry::new(&whole, &self.points, length));
        Self { matrix, mirrored: Some(mirrored), ..self }
    }
}
