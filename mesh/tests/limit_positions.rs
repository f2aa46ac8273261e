//! Where the boundary's vertices go, against going there.

mod common;

use common::bodies::{ball, distance, plate_with_hole};
use common::{hierarchy, smooth};
use nalgebra::{DMatrix, Matrix3};
use octruss_mesh::{
    CurveEnds, Features, Hierarchy, Level, Scheme, Step, SubdivisionMatrix, TetMesh, check,
    limit_matrix, shapes,
};

const APPROXIMATING: [Scheme; 3] = [Scheme::BoxSpline, Scheme::Averaged, Scheme::LOOP_SOLID];

fn limit_of(level: &Level, scheme: Scheme, ends: CurveEnds) -> SubdivisionMatrix {
    limit_matrix(&level.mesh, &level.topology, scheme, ends)
}

/// A mesh with creases and corners of its own, on an otherwise smooth boundary.
fn with_features(mesh: TetMesh, creases: &[[u32; 2]], corners: &[u32]) -> TetMesh {
    let mut raw = smooth(mesh).into_raw();
    let mut creases = creases.to_vec();
    creases.sort_unstable();
    let corners = corners.to_vec();
    raw.features = Some(Features { creases, corners, ..Features::default() });
    check(raw, &Default::default()).unwrap().mesh
}

/// Meshes with corners, smooth vertices of valence 3 and more, curves of one edge to
/// four, closed ones, and ends of creases in smooth surfaces.
fn meshes() -> Vec<(&'static str, TetMesh)> {
    let cube = shapes::kuhn_cube(2);
    // Along the x axis, then up; vertices are numbered x, then y, then z.
    let path = [[0, 1], [1, 2], [2, 11], [11, 20], [20, 23]];
    let tet = shapes::regular_tet();
    let closed = [[0, 1], [1, 2], [0, 2]];
    vec![
        ("cube with sharp edges", hierarchy(cube.clone()).into_finest().mesh),
        ("smooth tet", smooth(tet.clone())),
        ("smooth cube of five", smooth(shapes::five_tet_cube())),
        ("dart", with_features(cube.clone(), &path[..2], &[])),
        ("dart and corner", with_features(cube.clone(), &path[..3], &[0])),
        ("four edges", with_features(cube.clone(), &path[..4], &[0, 20])),
        ("three edges", with_features(cube.clone(), &path[..4], &[0, 11])),
        ("two edges", with_features(cube.clone(), &path[..2], &[0, 2])),
        ("one edge", with_features(cube, &path[..1], &[0, 1])),
        ("closed", with_features(tet.clone(), &closed, &[])),
        ("closed with a corner", with_features(tet.clone(), &closed, &[1])),
        ("dart of valence three", with_features(tet, &closed[..2], &[])),
        ("ball with a corner", with_features(ball(1), &[], &[3])),
        ("hole", hierarchy(plate_with_hole([8, 1, 1])).into_finest().mesh),
    ]
}

#[test]
fn a_limit_is_the_same_before_and_after_a_step() {
    for (name, mesh) in meshes() {
        for scheme in APPROXIMATING {
            for ends in CurveEnds::ALL {
                let mut levels = hierarchy(mesh.clone());
                levels.subdivide(Step { curve_ends: Some(ends), ..scheme.into() }).unwrap();
                let [before, after] = [levels.coarsest(), levels.finest()]
                    .map(|level| limit_of(level, scheme, ends).apply(level.mesh.points()));
                let strata = octruss_mesh::Strata::new(
                    mesh.raw(),
                    &levels.coarsest().topology,
                    mesh.features().unwrap(),
                );
                for (v, &limit) in before.iter().enumerate() {
                    if strata.vertex_dimensions[v] < 3 {
                        let miss = distance(limit, after[v]);
                        assert!(miss < 1e-14, "{name}, {scheme:?}, {ends:?}: {v} misses {miss:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn refined_vertices_go_to_the_limit_by_a_quarter_a_level() {
    for (name, mesh) in meshes().into_iter().skip(1).take(9) {
        let mut levels = hierarchy(mesh);
        let ends = CurveEnds::Parabola;
        let limits = limit_of(levels.coarsest(), Scheme::BoxSpline, ends)
            .apply(levels.coarsest().mesh.points());
        let moves: Vec<usize> = (0..limits.len())
            .filter(|&v| distance(limits[v], levels.coarsest().mesh.points()[v]) > 1e-12)
            .collect();
        let mut last = f64::INFINITY;
        for level in 0..4 {
            let points = levels.finest().mesh.points();
            let away = moves.iter().map(|&v| distance(points[v], limits[v])).fold(0.0, f64::max);
            // The second eigenvalues that count are at most 1/4 for curves, below 1/2 on
            // surfaces: at valence 3 the mean of the neighbours approaches at 1/16.
            assert!(level < 2 || away < 0.36 * last, "{name}: {away} after {last}");
            last = away;
            let step = Step { curve_ends: Some(ends), ..Scheme::BoxSpline.into() };
            if level < 3 {
                levels.subdivide(step).unwrap();
            }
        }
    }
}

#[test]
fn rows_are_those_of_the_literature() {
    let mesh = smooth(shapes::regular_tet());
    let levels = hierarchy(mesh);
    let limit = limit_of(levels.coarsest(), Scheme::BoxSpline, CurveEnds::Fixed);
    let (columns, weights) = limit.row(1);
    assert_eq!(columns, [0, 1, 2, 3]);
    assert!([0.2, 0.4, 0.2, 0.2].iter().zip(weights).all(|(a, b)| (a - b).abs() < 1e-15));
    for scheme in [Scheme::Linear, Scheme::INTERPOLATORY] {
        let limit = limit_of(levels.coarsest(), scheme, CurveEnds::Parabola);
        assert!((0..4).all(|v| limit.row(v) == (&[v as u32][..], &[1.0][..])));
    }
}

#[test]
fn the_rows_of_a_dart_have_a_closed_form() {
    // 5 l_j = l_(j−1) + l_(j+1) + 8 β is solved by cosh(ω (j − n/2)), cosh ω = 5/2.
    let levels = hierarchy(with_features(shapes::kuhn_cube(2), &[[3, 4]], &[]));
    let limit = limit_of(levels.coarsest(), Scheme::BoxSpline, CurveEnds::Fixed);
    // Vertex 4 is the middle of the face z = 0, which six triangles meet in.
    let (columns, weights) = limit.row(4);
    assert_eq!(columns, [0, 1, 3, 4, 5, 7, 8]);
    let (n, beta, omega) = (6.0, 1.0 / 16.0, 2.5f64.acosh());
    let l = |j: f64| {
        8.0 / 3.0 * beta * (1.0 - (omega * (j - n / 2.0)).cosh() / (omega * n / 2.0).cosh())
    };
    let crease = 2.0 * beta + 0.5 * l(1.0);
    let total = 1.0 + crease + (1..6).map(|j| l(f64::from(j))).sum::<f64>();
    // Round vertex 4 from 3 on: 3, 0, 1, 5, 8, 7.
    for (vertex, weight) in
        [(3, crease), (0, l(1.0)), (1, l(2.0)), (5, l(3.0)), (8, l(4.0)), (7, l(5.0)), (4, 1.0)]
    {
        let at = columns.binary_search(&vertex).unwrap();
        assert!((weights[at] - weight / total).abs() < 1e-15, "{vertex}");
    }
}

#[test]
fn the_limit_of_a_smooth_surface_can_be_solved_for() {
    // Λ = I − θ (I − D⁻¹ A), and the eigenvalues of D⁻¹ A are at least −1/2.
    for (mesh, least) in
        [(smooth(shapes::kuhn_cube(3)), 0.1), (ball(2), 0.25), (smooth(shapes::regular_tet()), 0.1)]
    {
        let levels = hierarchy(mesh);
        let limit = limit_of(levels.coarsest(), Scheme::BoxSpline, CurveEnds::Fixed);
        let n = limit.rows();
        // Rows scaled by what makes their neighbours' weights 1 are symmetric.
        let scale = |row: usize| {
            let (columns, weights) = limit.row(row);
            let other = columns.iter().position(|&c| c as usize != row);
            other.map_or(1.0, |at| weights[at].recip())
        };
        let mut dense = DMatrix::zeros(n, n);
        for row in 0..n {
            let (columns, weights) = limit.row(row);
            for (&c, w) in columns.iter().zip(weights) {
                dense[(row, c as usize)] = w * (scale(row) / scale(c as usize)).sqrt();
            }
        }
        assert!((&dense - dense.transpose()).amax() < 1e-12);
        let eigenvalues = dense.symmetric_eigenvalues();
        let [smallest, largest] = [eigenvalues.min(), eigenvalues.max()];
        assert!(smallest >= least - 1e-9 && largest <= 1.0 + 1e-9, "{smallest} to {largest}");
    }
}

/// The first vertices of the crease along the x axis of a box of some cells, on the level
/// after one step, in order: coarse vertices 0, 1, 2, … and the midpoints between.
fn along_x(levels: &Hierarchy, cells: u32) -> Vec<usize> {
    let coarse = levels.coarsest();
    let n = coarse.mesh.points().len();
    let midpoint = |v: u32| n + coarse.topology.edge_between(v, v + 1).unwrap() as usize;
    let pairs = (0..cells).flat_map(|v| [v as usize, midpoint(v)]);
    pairs.chain([cells as usize]).collect()
}

fn stepped(cells: u32) -> Hierarchy {
    let mut levels = hierarchy(shapes::kuhn_box([cells, 1, 1], [1.0; 3]));
    let curve_ends = Some(CurveEnds::Parabola);
    levels.subdivide(Step { curve_ends, ..Scheme::BoxSpline.into() }).unwrap();
    levels
}

/// Values along the x axis, stepped and taken to their limits.
fn limits_along_x(cells: u32, value: impl Fn(u32) -> f64) -> Vec<f64> {
    let levels = stepped(cells);
    let mut field = vec![0.0; levels.coarsest().mesh.points().len()];
    (0..=cells).for_each(|v| field[v as usize] = value(v));
    let refined = levels.refinement(0).matrix.apply_field(&field, 1);
    let limit = limit_of(levels.finest(), Scheme::BoxSpline, CurveEnds::Parabola);
    let limits = limit.apply_field(&refined, 1);
    along_x(&levels, cells).into_iter().map(|v| limits[v]).collect()
}

#[test]
fn parabola_ends_have_the_eigenvalues_of_a_parabola() {
    let levels = stepped(4);
    let places = along_x(&levels, 4);
    let matrix = &levels.refinement(0).matrix;
    let entry = |row: usize, column: u32| {
        let (columns, weights) = matrix.row(places[row]);
        columns.binary_search(&column).map_or(0.0, |at| weights[at])
    };
    let local = Matrix3::from_fn(|i, j| entry(i, j as u32));
    for eigenvalue in [0.25, 0.5, 1.0] {
        let shifted = local - Matrix3::identity() * eigenvalue;
        assert!(shifted.determinant().abs() < 1e-15, "{eigenvalue} of {local}");
    }
}

#[test]
fn parabolas_stay_parabolas_at_an_end() {
    // t² has the control points t² − 1/3 of a cubic B-spline; the end is its own limit.
    let square = |v: u32| if v == 0 { 0.0 } else { f64::from(v * v) - 1.0 / 3.0 };
    let limits = limits_along_x(6, square);
    for (i, limit) in limits[..8].iter().enumerate() {
        assert!((limit - (i as f64 / 2.0).powi(2)).abs() < 1e-13, "{i}: {limit}");
    }
    // Two edges from 0 to 2: 4/3 in the middle has the limit 1 of t (2 − t).
    let arch = limits_along_x(2, |v| if v == 1 { 4.0 / 3.0 } else { 0.0 });
    for (i, limit) in arch.iter().enumerate() {
        let t = i as f64 / 2.0;
        assert!((limit - t * (2.0 - t)).abs() < 1e-13, "{i}: {limit}");
    }
    // One edge is straight.
    assert_eq!(limits_along_x(1, f64::from), [0.0, 0.5, 1.0]);
    // Straight lines stay what they are, with any number of edges.
    for cells in 1..6 {
        let limits = limits_along_x(cells, f64::from);
        assert!(limits.iter().enumerate().all(|(i, x)| (x - i as f64 / 2.0).abs() < 1e-13));
    }
}
