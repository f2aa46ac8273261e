//! One step of a mesh whose limit passes through its boundary vertices, or whose boundary
//! vertices are put onto the limit.

use super::harmonic::extend;
use super::place::along_normals;
use super::solve;
use super::strain::count_strained;
use crate::core::control_points::{ControlPoints, Placement};
use crate::core::curve_ends::CurveEnds;
use crate::core::edge_length::mean_edge_length;
use crate::core::mirrors::Unfolded;
use crate::core::raw_mesh::RawMesh;
use crate::core::strata::Strata;
use crate::refinement::interpolation_report::InterpolationReport;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::subdivide::guard::{Guard, Pulls};
use crate::subdivide::rules::limit::LimitRules;
use octruss_base::vector3::{Vector3, length, subtract};

/// A vertex so near to its limit, in mean edge lengths, is it.
const ROUNDING: f64 = 1e-8;

/// A step as passing through sees it.
pub(crate) struct Step<'a> {
    pub coarse: &'a Unfolded<'a>,
    /// The coarse mesh itself.
    pub mesh: &'a RawMesh,
    /// Whatever its positions.
    pub fine: Unfolded<'a>,
    /// The scheme's; its columns are unfolded vertices.
    pub matrix: &'a SubdivisionMatrix,
    pub curve_ends: CurveEnds,
    /// Whether the limit is to pass through the vertices of the input.
    pub interpolates: bool,
    /// Whether boundary vertices go to their limits, wherever these are.
    pub projects: bool,
    pub guard: &'a Guard<'a>,
    /// Whether the guard pulls vertices back; if not, it is only asked whether it would,
    /// when the placement is chosen.
    pub is_guarded: bool,
}

/// What became of it.
pub(crate) struct Passed {
    pub points: Vec<Vector3>,
    pub control_points: ControlPoints,
    pub report: InterpolationReport,
    /// What the guard did, if it was to.
    pub pulls: Option<Pulls>,
}

/// New positions with one of the placements, before the guard.
struct Placed {
    placement: Placement,
    points: Vec<Vector3>,
    /// Of all fine vertices.
    control_points: Vec<Vector3>,
}

impl Step<'_> {
    /// Places the fine vertices.
    ///
    /// Without control points from a step before, they are solved for, and the placement
    /// is chosen: along normals, unless the guard would pull boundary vertices back then,
    /// and fewer at the limit.
    pub fn pass(&self) -> Passed {
        let strata = Strata::unfolded(self.coarse);
        let fine = FineStrata::new(&self.fine);
        let mut report = InterpolationReport::default();
        let recorded = self.mesh.features.as_ref().and_then(|all| all.control_points.as_ref());
        if !self.interpolates {
            let placed = self.project(&fine, recorded);
            return self.guarded(placed, &fine, report);
        }
        if let Some(recorded) = recorded {
            let control_points = recorded.of_all(&self.mesh.points);
            let placed = self.place(recorded.placement, &strata, &fine, &control_points);
            return self.guarded(placed, &fine, report);
        }
        let mut control_points = self.solve(&strata, &mut report);
        let normal = self.place(Placement::AlongNormals, &strata, &fine, &control_points);
        let pulled = self.pulled_boundary(&normal, &fine);
        if pulled == 0 {
            return self.guarded(normal, &fine, report);
        }
        extend(self.coarse, &listed(&strata, self.coarse), &mut control_points);
        let at_limit = self.place(Placement::AtLimit, &strata, &fine, &control_points);
        let is_better = self.pulled_boundary(&at_limit, &fine) < pulled;
        self.guarded(if is_better { at_limit } else { normal }, &fine, report)
    }

    /// By the scheme's rows, then from curves and surfaces to their limits.
    fn project(&self, fine: &FineStrata, recorded: Option<&ControlPoints>) -> Placed {
        let points = &self.mesh.points;
        let control_points = recorded.map_or_else(|| points.clone(), |all| all.of_all(points));
        let control_points = self.matrix.apply(&self.coarse.with_images(&control_points));
        let mut points = control_points.clone();
        for (&vertex, limit) in
            fine.listed.iter().zip(fine.limits(self.curve_ends, &control_points))
        {
            points[vertex as usize] = limit;
        }
        Placed { placement: Placement::AlongNormals, points, control_points }
    }

    fn solve(&self, strata: &Strata, report: &mut InterpolationReport) -> Vec<Vector3> {
        let Self { coarse, curve_ends, .. } = *self;
        let topology = &*coarse.topology;
        let edge_length = mean_edge_length(&coarse.mesh.points, topology);
        let rules = LimitRules { strata, topology, curve_ends };
        let listed = listed(strata, coarse);
        let solved = solve::control_points(&rules, coarse, &listed, edge_length);
        let (points, control_points) = (&coarse.mesh.points, &solved.control_points);
        report.strained =
            count_strained(&rules, points, &listed, &coarse.with_images(control_points));
        report.iterations = solved.iterations;
        report.residual = solved.residual;
        report.has_converged = solved.has_converged;
        solved.control_points
    }

    fn place(
        &self,
        placement: Placement,
        strata: &Strata,
        fine: &FineStrata,
        control_points: &[Vector3],
    ) -> Placed {
        let n = self.coarse.vertices();
        let mut refined = self.matrix.apply(&self.coarse.with_images(control_points));
        if placement == Placement::AlongNormals {
            // The end of a crease inside the solid is fixed as long as the solid is.
            let fixed = fine.listed.iter().map(|&v| v as usize).take_while(|&v| v < n);
            for v in fixed.filter(|&v| strata.vertex_dimensions[v] == 3) {
                refined[v] = control_points[v];
            }
        }
        let limits = fine.limits(self.curve_ends, &refined);
        let mut points = match placement {
            Placement::AlongNormals => {
                let coarse = (self.coarse, strata);
                along_normals(coarse, &self.fine, &fine.listed, &limits, self.projects)
            }
            Placement::AtLimit => {
                let mut points = refined.clone();
                for (&vertex, &limit) in fine.listed.iter().zip(&limits) {
                    // What is the limit of an old vertex, but for rounding, is that vertex.
                    let old = self.mesh.points.get(vertex as usize);
                    points[vertex as usize] = old.copied().unwrap_or(limit);
                }
                points
            }
        };
        if self.projects {
            // Vertices of the levels between stand beside their limits.
            let rounding =
                ROUNDING * mean_edge_length(&self.coarse.mesh.points, &self.coarse.topology);
            for (&vertex, limit) in
                fine.listed.iter().zip(limits).take_while(|(v, _)| **v < n as u32)
            {
                let point = &mut points[vertex as usize];
                if length(subtract(limit, *point)) > rounding {
                    *point = limit;
                }
            }
        }
        Placed { placement, points, control_points: refined }
    }

    /// How many vertices of curves and surfaces the guard pulls back.
    fn pulled_boundary(&self, placed: &Placed, fine: &FineStrata) -> usize {
        let Pulls { shares, .. } = self.guard.pull_back(&mut placed.points.clone());
        let pulled = |&&v: &&u32| shares.get(v as usize).is_some_and(|&share| share > 0);
        fine.listed.iter().filter(pulled).count()
    }

    fn guarded(
        &self,
        placed: Placed,
        fine: &FineStrata,
        mut report: InterpolationReport,
    ) -> Passed {
        let Placed { placement, mut points, control_points } = placed;
        report.placement = placement;
        let mut pulls = None;
        if self.is_guarded {
            let unpulled = points.clone();
            pulls = Some(self.guard.pull_back(&mut points));
            let pulled = |&v: &u32| {
                let [before, after] = [&unpulled, &points].map(|points| points[v as usize]);
                length(subtract(before, after))
            };
            report.left_to_limit = fine.listed.iter().map(pulled).fold(0.0, f64::max);
        }
        let vertices = match placement {
            Placement::AlongNormals => fine.listed.clone(),
            Placement::AtLimit => (0..points.len() as u32).collect(),
        };
        let positions = vertices.iter().map(|&v| control_points[v as usize]).collect();
        let curve_ends = self.curve_ends;
        let control_points = ControlPoints { vertices, positions, placement, curve_ends };
        Passed { points, control_points, report, pulls }
    }
}

/// The strata of the fine mesh, and its own vertices of those below the solid.
struct FineStrata<'a> {
    mesh: &'a Unfolded<'a>,
    strata: Strata,
    listed: Vec<u32>,
}

impl<'a> FineStrata<'a> {
    fn new(mesh: &'a Unfolded) -> Self {
        let strata = Strata::unfolded(mesh);
        let listed = listed(&strata, mesh);
        Self { mesh, strata, listed }
    }

    /// The limit of each listed vertex.
    fn limits(&self, curve_ends: CurveEnds, control_points: &[Vector3]) -> Vec<Vector3> {
        let topology = &*self.mesh.topology;
        let rules = LimitRules { strata: &self.strata, topology, curve_ends };
        let (rows, columns) = (self.listed.len(), topology.vertex_count());
        let limit = SubdivisionMatrix::from_rows(rows, columns, |row, entries| {
            rules.row(self.listed[row], entries);
        });
        limit.apply(&self.mesh.with_images(control_points))
    }
}

/// The mesh's own vertices of strata below the solid.
fn listed(strata: &Strata, mesh: &Unfolded) -> Vec<u32> {
    let mut listed = strata.listed();
    listed.truncate(listed.partition_point(|&v| (v as usize) < mesh.vertices()));
    listed
}
