//! Blends two materials in a bar: a density given at coarse vertices is carried
//! onto finer meshes, once by linear interpolation and once by the box-spline
//! scheme.
//!
//!     cargo run --release --example 02_blended_cylinder
//!
//! The density is 7.8 up to the vertices at z = 1 and 2.7 from those at z = 1.5
//! on. Interpolated linearly it falls by (7.8 − 2.7) / 0.5 = 10.2 a unit of
//! length in between, and its slope jumps by 10.2 at both ends of the slope,
//! however often the mesh is split. The box-spline scheme blends: its slope is
//! continuous in the limit, so that each level about halves the jumps from tet to
//! tet.

use octruss_mesh::reference_tet::six_volumes;
use octruss_mesh::{
    CheckOptions, FeatureOptions, Hierarchy, Overshoot, Scheme, TetMesh, carry_field, check,
};
use octruss_meshio::Values;

const LEVELS: usize = 3;

/// Refines, and compares the slopes along the axis.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    let linear = largest_jumps(Scheme::Linear)?;
    let blended = largest_jumps(Scheme::BoxSpline)?;
    println!("largest jump of the slope from tet to tet along the axis");
    println!("level    linear  box-spline");
    for (level, (linear, blended)) in linear.iter().zip(&blended).enumerate() {
        println!("{level:>5} {linear:>9.4} {blended:>11.4}");
    }
    for level in 0..=LEVELS {
        assert!((linear[level] - 10.2).abs() < 1e-9);
    }
    for level in 1..LEVELS {
        assert!(blended[level + 1] < 0.6 * blended[level]);
    }
    Ok(())
}

/// The largest jump of the slope on each level, the coarsest first.
fn largest_jumps(scheme: Scheme) -> Result<Vec<f64>, Box<dyn std::error::Error>> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/meshes/cylinder.msh");
    let dataset = octruss_meshio::read(path.as_ref())?;
    let [density] = &dataset.point_fields[..] else { return Err("expected one field".into()) };
    let Values::Float(density) = &density.values else { return Err("expected numbers".into()) };
    let mesh = check(dataset.mesh, &CheckOptions::default())?.mesh;

    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    let mut density = density.clone();
    let mut jumps = vec![largest_jump(&hierarchy.finest().mesh, &density)];
    for level in 0..LEVELS {
        hierarchy.subdivide(scheme)?;
        // The matrix that moved the vertices carries the density, too.
        let matrix = &hierarchy.refinement(level).matrix;
        density = carry_field(matrix, &density, 1, Overshoot::Allow).values;
        jumps.push(largest_jump(&hierarchy.finest().mesh, &density));
    }
    // All weights are positive and sum to one.
    assert!(density.iter().all(|value| (2.7 - 1e-9..7.8 + 1e-9).contains(value)));
    Ok(jumps)
}

/// A line along the axis, a little off it so that it runs through tets and not
/// along their edges.
const X: f64 = 0.0103;
const Y: f64 = 0.0061;

/// How much the slope of a field along the line changes from tet to tet at most.
fn largest_jump(mesh: &TetMesh, field: &[f64]) -> f64 {
    let mut pieces: Vec<(f64, f64)> =
        (0..mesh.tets().len()).filter_map(|tet| piece(mesh, field, tet)).collect();
    pieces.sort_by(|p, q| p.0.total_cmp(&q.0));
    let jumps = pieces.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs());
    jumps.fold(0.0, f64::max)
}

/// Where the line enters a tet, and the slope of the field there; none for tets
/// that it misses.
fn piece(mesh: &TetMesh, field: &[f64], tet: usize) -> Option<(f64, f64)> {
    let corners = mesh.corners(tet);
    let beside = |axis: usize, at: f64| {
        corners.iter().all(|p| p[axis] < at) || corners.iter().all(|p| p[axis] > at)
    };
    if beside(0, X) || beside(1, Y) {
        return None;
    }
    // Barycentric coordinate i along the line is start + z · rate.
    let coordinate = |i: usize, z: f64| {
        let mut with = corners;
        with[i] = [X, Y, z];
        six_volumes(with) / six_volumes(corners)
    };
    let (mut enters, mut leaves, mut slope) = (f64::NEG_INFINITY, f64::INFINITY, 0.0);
    for (i, &vertex) in mesh.tets()[tet].iter().enumerate() {
        let start = coordinate(i, 0.0);
        let rate = coordinate(i, 1.0) - start;
        slope += rate * field[vertex as usize];
        // Positive between where it vanishes and where another one does.
        match -start / rate {
            _ if rate == 0.0 && start < 0.0 => return None,
            _ if rate == 0.0 => {}
            zero if rate > 0.0 => enters = enters.max(zero),
            zero => leaves = leaves.min(zero),
        }
    }
    (enters + 1e-12 < leaves).then_some((enters, slope))
}
