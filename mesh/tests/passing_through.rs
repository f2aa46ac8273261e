//! Refining with the limit through the boundary vertices of the input.

mod common;

use std::f64::consts::TAU;

use common::bodies::{ball, bent, distance, pipe, plate_with_hole, radius, turned, volume};
use common::hierarchy;
use octruss_mesh::{
    ControlPoints, CurveEnds, Hierarchy, Level, Placement, Scheme, Step, Strata, TetMesh, guard,
    limit_matrix, quality, shapes,
};

const THROUGH: Step = Step {
    scheme: Scheme::BoxSpline,
    diagonal: octruss_mesh::Diagonal::Inherit,
    min_quality: None,
    interpolate: true,
    project_limit: false,
    curve_ends: None,
};

fn through(mesh: TetMesh, levels: usize) -> Hierarchy {
    stepped(mesh, THROUGH, levels)
}

fn stepped(mesh: TetMesh, step: Step, levels: usize) -> Hierarchy {
    let mut hierarchy = hierarchy(mesh);
    for _ in 0..levels {
        hierarchy.subdivide(step).unwrap();
    }
    hierarchy
}

fn eta_min(mesh: &TetMesh) -> f64 {
    quality::summarise(mesh.raw()).unwrap().eta.min
}

fn control_points(mesh: &TetMesh) -> &ControlPoints {
    mesh.features().unwrap().control_points.as_ref().expect("control points are kept")
}

/// The limits of the control points of a level, for vertices that have some.
fn limits(level: &Level, ends: CurveEnds) -> Vec<(usize, [f64; 3])> {
    let ControlPoints { vertices, positions, .. } = control_points(&level.mesh);
    let mut all = level.mesh.points().to_vec();
    vertices.iter().zip(positions).for_each(|(&v, &position)| all[v as usize] = position);
    let limit = limit_matrix(&level.mesh, &level.topology, Scheme::BoxSpline, ends).apply(&all);
    vertices.iter().map(|&v| (v as usize, limit[v as usize])).collect()
}

/// The mean over some limits of how far they are from a radius, relative to it.
fn mean_miss(points: impl Iterator<Item = f64>, exact: f64) -> f64 {
    let misses: Vec<f64> = points.map(|r| (r / exact - 1.0).abs()).collect();
    misses.iter().sum::<f64>() / misses.len() as f64
}

fn bodies() -> Vec<(&'static str, TetMesh)> {
    vec![
        ("ball", ball(2)),
        ("pipe", pipe([12, 2, 4], [1.0, 2.0], 2.0)),
        ("plate", plate_with_hole([16, 3, 1])),
        ("cube", shapes::kuhn_cube(2)),
        ("arc", arc()),
    ]
}

/// A quarter of a ring of radius 1 inside, in six cells of 15°, with sharp edges.
fn arc() -> TetMesh {
    bent([6, 1, 1], |[x, y, z]| turned(x / 24.0, 1.0 + 0.3 * y, 0.3 * z))
}

#[test]
fn the_limit_passes_through_the_vertices_of_the_input() {
    for (name, mesh) in bodies() {
        for scheme in [Scheme::BoxSpline, Scheme::Averaged, Scheme::LOOP_SOLID] {
            let levels = stepped(mesh.clone(), Step { scheme, ..THROUGH }, 2);
            let input = levels.coarsest().mesh.points();
            for level in &levels.levels()[1..] {
                for (v, limit) in limits(level, CurveEnds::Parabola) {
                    if let Some(&vertex) = input.get(v) {
                        // Edges have a length of about 1/2.
                        assert!(distance(limit, vertex) < 1e-10, "{name}: {v}");
                        assert_eq!(level.mesh.points()[v], vertex, "{name}: {v} stays");
                    }
                }
            }
            let report = levels.refinement(0).interpolation.unwrap();
            assert_eq!(report.strained, 0, "{name}");
            assert!(report.iterations.iter().all(|&n| n <= 25), "{name}: {report:?}");
            assert!(report.residual < 1e-10, "{name}: {report:?}");
            assert_eq!(levels.refinement(1).interpolation.unwrap().iterations, [0, 0]);
        }
    }
}

#[test]
fn creases_that_end_in_a_surface_are_solved_for_too() {
    let mut raw = shapes::kuhn_cube(3).into_raw();
    let options = octruss_mesh::FeatureOptions {
        crease_angle: 180.0,
        group_borders: octruss_mesh::GroupBorders::None,
        ..Default::default()
    };
    raw.edges.push([0, 1], 1);
    raw.edges.push([1, 2], 1);
    raw.edges.push([60, 61], 1);
    let mesh = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
    let mut levels = Hierarchy::new(mesh, &options);
    levels.subdivide(THROUGH).unwrap();
    for (v, limit) in limits(levels.finest(), CurveEnds::Parabola) {
        if let Some(&vertex) = levels.coarsest().mesh.points().get(v) {
            assert!(distance(limit, vertex) < 1e-10, "{v}: {limit:?} for {vertex:?}");
        }
    }
}

#[test]
fn matrices_lead_from_positions_to_positions() {
    for (name, mesh) in bodies() {
        let levels = through(mesh, 2);
        for transfer in 0..2 {
            let matrix = &levels.refinement(transfer).matrix;
            assert!(levels.affine_defect(transfer, matrix) < 1e-11, "{name}");
            for row in 0..matrix.rows() {
                let sum: f64 = matrix.row(row).1.iter().sum();
                assert!((sum - 1.0).abs() < 1e-12, "{name}: row {row} sums to {sum}");
            }
        }
    }
}

#[test]
fn flat_faces_are_split_linearly() {
    let linear = |mesh: TetMesh| stepped(mesh, Scheme::Linear.into(), 2).into_finest().mesh;
    let cube = through(shapes::kuhn_cube(2), 2).into_finest().mesh;
    let expected = linear(shapes::kuhn_cube(2));
    for (found, expected) in cube.points().iter().zip(expected.points()) {
        assert!(distance(*found, *expected) < 1e-14);
    }
    // On the faces of a plate all but the rim of the hole is halved.
    let mesh = plate_with_hole([16, 3, 1]);
    let [found, expected] = [through(mesh.clone(), 1).into_finest().mesh, linear(mesh.clone())];
    let on_face = |p: &[f64; 3]| p[2] == 0.0 || p[2] == 1.0;
    for (found, expected) in found.points().iter().zip(expected.points()) {
        if on_face(expected) {
            assert!((found[2] - expected[2]).abs() < 1e-14);
            if radius(*expected) > 1.0 + 1e-9 {
                assert!(distance(*found, *expected) < 1e-14, "{found:?} for {expected:?}");
            }
        }
    }
}

#[test]
fn a_regular_pipe_is_round_to_fourth_order() {
    let miss = |segments: u32| {
        let along = 2 + segments / 4;
        let levels = through(pipe([segments, 3, along], [1.0, 2.0], f64::from(along) * 0.5), 3);
        let limits = limits(levels.finest(), CurveEnds::Parabola).into_iter();
        let outside = limits.map(|(_, limit)| radius(limit)).filter(|&r| r > 1.99);
        mean_miss(outside, 2.0)
    };
    let [coarse, fine] = [12, 24].map(miss);
    assert!(coarse <= 1.2e-4, "{coarse:e}");
    assert!(fine <= 7e-6, "{fine:e}");
    assert!(coarse / fine > 14.0, "{}", coarse / fine);
}

#[test]
fn arcs_end_in_their_tangents() {
    let measure = |curve_ends: CurveEnds| {
        let step = Step { curve_ends: Some(curve_ends), ..THROUGH };
        let levels = stepped(arc(), step, 3);
        let mut inner: Vec<[f64; 3]> = limits(levels.finest(), curve_ends)
            .into_iter()
            .map(|(_, limit)| limit)
            .filter(|limit| limit[2] == 0.0 && (radius(*limit) - 1.0).abs() < 0.02)
            .collect();
        assert_eq!(inner.len(), 6 * 8 + 1);
        inner.sort_by(|p, q| p[1].total_cmp(&q[1]));
        let worst = inner.iter().map(|p| (radius(*p) - 1.0).abs()).fold(0.0, f64::max);
        // The tangent of the parabola through the first three points, which should be +y.
        let [x, y] = [0, 1].map(|k| 4.0 * inner[1][k] - 3.0 * inner[0][k] - inner[2][k]);
        (x.atan2(y).to_degrees().abs(), worst)
    };
    let (angle, miss) = measure(CurveEnds::Parabola);
    assert!(angle < 0.15 && miss < 6e-5, "{angle}° and {miss:e}");
    let (angle, miss) = measure(CurveEnds::Fixed);
    assert!(angle > 3.0 && miss > 3e-3, "{angle}° and {miss:e}");
}

#[test]
fn refining_twice_is_refining_by_two_levels() {
    for (name, mesh) in bodies() {
        let floor = 0.5 * eta_min(&mesh);
        let step = Step { min_quality: Some(floor), ..THROUGH };
        let once = stepped(mesh.clone(), step, 1).into_finest().mesh;
        let twice = stepped(once, step, 1).into_finest().mesh;
        assert!(twice == stepped(mesh, step, 2).into_finest().mesh, "{name}");
    }
}

#[test]
fn volumes_come_near_the_exact_ones() {
    // A regular polygon of n sides takes up this much of its circle.
    let polygon = |n: f64| (TAU / n).sin() / (TAU / n);
    for (name, mesh, exact, facets, within) in [
        ("ball", ball(2), 2.0 / 3.0 * TAU, 1.0, 0.007),
        ("pipe", pipe([12, 2, 4], [1.0, 2.0], 2.0), 3.0 * TAU, polygon(96.0), 3e-4),
        ("plate", plate_with_hole([16, 3, 1]), 16.0 - TAU / 2.0, 1.0, 5e-4),
    ] {
        let plain = volume(&stepped(mesh.clone(), Scheme::BoxSpline.into(), 2).finest().mesh);
        let levels = through(mesh, 3);
        let [input, smooth] = [levels.coarsest(), levels.finest()].map(|level| volume(&level.mesh));
        let miss = |volume: f64| (volume / exact - 1.0).abs();
        assert!(miss(smooth / facets) < within, "{name}: {smooth} of {exact}");
        assert!(miss(plain) > miss(input) && miss(input) > 10.0 * miss(smooth), "{name}");
    }
}

#[test]
fn tets_keep_their_quality_without_a_guard() {
    for (name, mesh, share) in [
        ("ball", ball(2), 0.9),
        ("pipe", pipe([12, 2, 4], [1.0, 2.0], 2.0), 0.85),
        ("plate", plate_with_hole([16, 3, 1]), 0.8),
        ("cube", shapes::kuhn_cube(2), 1.0),
    ] {
        let start = eta_min(&mesh);
        let levels = through(mesh, 2);
        let end = eta_min(&levels.finest().mesh);
        assert!(end >= share * start - 1e-12, "{name}: {end} after {start}");
        assert_eq!(control_points(&levels.finest().mesh).placement, Placement::AlongNormals);
    }
}

#[test]
fn thin_walls_go_to_the_limit_itself() {
    let mesh = pipe([12, 2, 12], [1.75, 2.0], 12.0);
    let floor = guard::usual_floor(&mesh);
    let step = Step { min_quality: Some(floor), ..THROUGH };
    let levels = stepped(mesh, step, 2);
    assert!(eta_min(&levels.finest().mesh) >= floor * (1.0 - 1e-8));
    for transfer in 0..2 {
        let report = levels.refinement(transfer).interpolation.unwrap();
        assert_eq!(report.placement, Placement::AtLimit);
        assert_eq!(report.left_to_limit, 0.0);
        let matrix = &levels.refinement(transfer).matrix;
        assert!(levels.affine_defect(transfer, matrix) < 1e-10);
    }
    let polygon = 24.0 * (TAU / 48.0).sin();
    let exact = polygon * (4.0 - 1.75 * 1.75) * 12.0;
    assert!((volume(&levels.finest().mesh) / exact - 1.0).abs() < 3e-4);
}

#[test]
fn a_guard_tells_how_far_from_the_limit_it_left_the_boundary() {
    let mesh = ball(1);
    let floor = 0.995 * eta_min(&mesh);
    let levels = stepped(mesh, Step { min_quality: Some(floor), ..THROUGH }, 1);
    let free = through(ball(1), 1);
    let [guarded, free] = [&levels, &free].map(|levels| levels.finest().mesh.points());
    let moved = guarded.iter().zip(free).map(|(p, q)| distance(*p, *q)).fold(0.0, f64::max);
    let refinement = levels.refinement(0);
    let report = refinement.interpolation.unwrap();
    assert!(refinement.guard.unwrap().pulled_back > 0);
    assert!(report.left_to_limit > 0.0 && report.left_to_limit <= moved + 1e-15, "{report:?}");
    assert!(levels.affine_defect(0, &refinement.matrix) < 1e-11);
}

#[test]
fn schemes_that_keep_vertices_are_as_without() {
    for scheme in [Scheme::Linear, Scheme::INTERPOLATORY] {
        let plain = stepped(ball(1), scheme.into(), 2).into_finest().mesh;
        let asked = stepped(ball(1), Step { scheme, ..THROUGH }, 2).into_finest().mesh;
        assert!(plain == asked);
        assert!(asked.features().unwrap().control_points.is_none());
    }
}

#[test]
fn a_step_without_leaves_no_control_points_behind() {
    let mut levels = through(ball(1), 1);
    levels.subdivide(Scheme::BoxSpline).unwrap();
    assert!(levels.finest().mesh.features().unwrap().control_points.is_none());
}

#[test]
fn control_points_are_those_of_the_boundary() {
    let levels = through(ball(1), 1);
    let Level { mesh, topology, .. } = levels.finest();
    let strata = Strata::new(mesh.raw(), topology, mesh.features().unwrap());
    let lower = (0u32..).zip(&strata.vertex_dimensions).filter(|(_, dimension)| **dimension < 3);
    let lower: Vec<u32> = lower.map(|(v, _)| v).collect();
    assert_eq!(control_points(mesh).vertices, lower);
}

#[test]
fn numbers_of_threads_do_not_matter() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| through(pipe([12, 2, 12], [1.9, 2.0], 12.0), 2).into_finest().mesh)
    };
    assert!(run(1) == run(3));
}

#[test]
fn distances_tell_what_smoothing_takes_away_and_passing_through_keeps() {
    let plain = Step::from(Scheme::BoxSpline);
    let shrunk = stepped(ball(2), plain, 2);
    let kept = through(ball(2), 2);
    // A smooth surface through the ball's vertices is closer than the plain limit by far.
    let [before, after] = [0, 2].map(|level| shrunk.limit_distances(level, plain));
    // The limit is the same; only its facets, which tell the normals, are finer.
    assert!((before.input_largest / after.input_largest - 1.0).abs() < 0.02, "{after:?}");
    assert_eq!((before.largest, before.mean), (before.input_largest, before.input_mean));
    assert!(before.mean > 0.03 && before.largest < 0.1, "{before:?}");
    assert!(after.largest < 0.1 * before.largest, "{after:?}");
    let kept = [0, 1, 2].map(|level| kept.limit_distances(level, THROUGH));
    assert_eq!(kept[0], Default::default());
    for distances in &kept[1..] {
        assert!(distances.input_largest < 1e-10 && distances.input_mean < 1e-10);
        assert!(distances.mean < 0.03 * before.mean, "{distances:?} {before:?}");
    }
    let levels = stepped(ball(1), Scheme::INTERPOLATORY.into(), 1);
    assert_eq!(levels.limit_distances(1, Scheme::INTERPOLATORY), Default::default());
}

#[test]
fn vertices_in_bad_triangles_are_counted() {
    // A ball with one vertex of the surface pushed close to a neighbour.
    let mut raw = ball(2).into_raw();
    let levels = hierarchy(ball(2));
    let strata = Strata::new(
        levels.coarsest().mesh.raw(),
        &levels.coarsest().topology,
        levels.coarsest().mesh.features().unwrap(),
    );
    let v = strata.vertex_dimensions.iter().position(|&dimension| dimension == 2).unwrap();
    let to = strata.surface_neighbours(v as u32)[0] as usize;
    let pushed: [f64; 3] =
        std::array::from_fn(|k| 0.15 * raw.points[v][k] + 0.85 * raw.points[to][k]);
    raw.points[v] = pushed.map(|x| x / distance(pushed, [0.0; 3]));
    let mesh = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
    let floor = guard::usual_floor(&mesh);
    let levels = stepped(mesh, Step { min_quality: Some(floor), ..THROUGH }, 1);
    assert!(levels.refinement(0).interpolation.unwrap().strained > 0);
}

#[test]
fn a_mesh_without_features_is_smooth_and_keeps_control_points_too() {
    let mesh = shapes::five_tet_cube();
    let topology = octruss_mesh::Topology::new(mesh.raw());
    let (bare, ..) = octruss_mesh::subdivide(&mesh, &topology, THROUGH, 1).unwrap();
    let smooth = stepped(common::smooth(mesh), THROUGH, 1).into_finest().mesh;
    assert_eq!(bare.points(), smooth.points());
    assert_eq!(control_points(&bare), control_points(&smooth));
}
