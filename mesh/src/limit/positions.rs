//! Where the boundary's vertices go if a scheme refines without end.

use crate::core::raw_mesh::Features;
use crate::core::strata::Strata;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::scheme::Scheme;
use crate::subdivide::curve_ends::CurveEnds;
use crate::subdivide::rules::limit::LimitRules;

/// The matrix Λ, n × n, that takes the control points of a mesh to their limits on
/// curves and surfaces (the boundary, interfaces, surfaces asked for); rows sum to one
/// and read their own stratum and those below it.
///
/// Corners are their own limit. A curve vertex has (1, 4, 1)/6, beside a parabola end
/// (1, 5, 1)/7, between two (1, 6, 1)/8; a surface vertex with n > 3 neighbours 1/2 and
/// 1/(2n) each, with three 2/5 and 1/5 (Loop's rule with Warren's weights). It is the
/// same for all approximating schemes, and the identity for those that keep vertices.
/// Vertices of the solid have a row of the identity, too: their limits depend on the
/// scheme and are not given here.
///
/// ```
/// use octruss_mesh::{CurveEnds, Hierarchy, Scheme, limit_matrix, shapes};
/// // A limit is the same before and after a step.
/// let mut levels = Hierarchy::new(shapes::kuhn_cube(2), &Default::default());
/// levels.subdivide(Scheme::BoxSpline)?;
/// let limits = [levels.coarsest(), levels.finest()].map(|level| {
///     let fixed = CurveEnds::Fixed;
///     let limit = limit_matrix(&level.mesh, &level.topology, Scheme::BoxSpline, fixed);
///     limit.apply(level.mesh.points())
/// });
/// assert!((0..3).all(|k| (limits[0][1][k] - limits[1][1][k]).abs() < 1e-12));
/// # Ok::<(), octruss_mesh::SubdivideError>(())
/// ```
pub fn limit_matrix(
    mesh: &TetMesh,
    topology: &Topology,
    scheme: Scheme,
    curve_ends: CurveEnds,
) -> SubdivisionMatrix {
    let n = topology.vertex_count();
    if scheme.keeps_vertices() {
        return SubdivisionMatrix::from_rows(n, n, |row, entries| entries.add(row as u32, 1.0));
    }
    let smooth = Features::default();
    let strata = Strata::new(mesh.raw(), topology, mesh.features().unwrap_or(&smooth));
    let rules = LimitRules { strata: &strata, topology, curve_ends };
    SubdivisionMatrix::from_rows(n, n, |row, entries| rules.row(row as u32, entries))
}
