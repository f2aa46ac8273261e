//! Where the boundary's vertices go if a scheme refines without end.

use crate::core::curve_ends::CurveEnds;
use crate::core::mirrors::Unfolded;
use crate::core::strata::Strata;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::refinement::folded::folded;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::scheme::Scheme;
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
/// scheme and are not given here. Beside mirror planes rows are those for fields, see
/// [`crate::Refinement::mirrored`]; for positions see [`limit_positions`].
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
    let unfolded = Unfolded::new(mesh.raw(), topology);
    folded(unfolded_limit_matrix(&unfolded, curve_ends), &unfolded)
}

/// The limits of control points, one a vertex, on curves and surfaces, in mesh units: the
/// product with [`limit_matrix`], but beside mirror planes with reflected control points.
///
/// # Panics
/// If there are not as many control points as vertices.
pub fn limit_positions(
    mesh: &TetMesh,
    topology: &Topology,
    (scheme, curve_ends): (Scheme, CurveEnds),
    control_points: &[[f64; 3]],
) -> Vec<[f64; 3]> {
    assert_eq!(control_points.len(), topology.vertex_count(), "one control point a vertex");
    if scheme.keeps_vertices() {
        return control_points.to_vec();
    }
    let unfolded = Unfolded::new(mesh.raw(), topology);
    let limit = unfolded_limit_matrix(&unfolded, curve_ends);
    limit.apply(&unfolded.with_images(control_points))
}

/// The rows of a mesh's own vertices; columns are unfolded ones.
fn unfolded_limit_matrix(unfolded: &Unfolded, curve_ends: CurveEnds) -> SubdivisionMatrix {
    let (topology, columns) = (&*unfolded.topology, unfolded.topology.vertex_count());
    let strata = Strata::unfolded(unfolded);
    let rules = LimitRules { strata: &strata, topology, curve_ends };
    SubdivisionMatrix::from_rows(unfolded.vertices(), columns, |row, entries| {
        rules.row(row as u32, entries);
    })
}
