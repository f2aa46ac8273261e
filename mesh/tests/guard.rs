//! The quality guard: never below the floor, and only where needed.

mod common;

use common::{hierarchy, smooth};
use octruss_mesh::{
    Diagonal, FeatureOptions, Hierarchy, Scheme, Step, TetMesh, guard::lattice_mean_ratio, quality,
    shapes,
};

fn eta_min(mesh: &TetMesh) -> f64 {
    quality::summarise(mesh.raw()).unwrap().eta.min
}

fn guarded(mesh: TetMesh, scheme: Scheme, floor: f64, levels: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    for _ in 0..levels {
        hierarchy.subdivide(Step { min_quality: Some(floor), ..scheme.into() }).unwrap();
    }
    hierarchy
}

#[test]
fn a_smooth_tet_stays_above_the_floor_where_unguarded_it_falls_below() {
    // Without the guard the corner chain halves η at every level: .037 at level 4.
    let mut free = hierarchy(smooth(shapes::regular_tet()));
    for _ in 0..4 {
        free.subdivide(Scheme::LOOP_SOLID).unwrap();
    }
    assert!(eta_min(&free.finest().mesh) < 0.04);
    for scheme in [Scheme::LOOP_SOLID, Scheme::BoxSpline] {
        let levels = guarded(smooth(shapes::regular_tet()), scheme, 0.5, 4);
        for mesh in levels.levels().iter().map(|level| &level.mesh) {
            assert!(eta_min(mesh) >= 0.5 - 1e-9, "{}", eta_min(mesh));
        }
        let report = levels.refinement(3).guard.unwrap();
        let all = levels.refinement(3).matrix.rows();
        assert!(report.pulled_back > 0 && report.pulled_back < all / 3, "{report:?} of {all}");
    }
}

#[test]
fn a_mesh_above_the_floor_is_left_as_it_is() {
    let levels = guarded(shapes::kuhn_cube(2), Scheme::BoxSpline, 0.3, 2);
    let mut free = Hierarchy::new(shapes::kuhn_cube(2), &FeatureOptions::default());
    free.subdivide(Scheme::BoxSpline).unwrap();
    free.subdivide(Scheme::BoxSpline).unwrap();
    assert_eq!(&levels.finest().mesh, &free.finest().mesh);
    assert_eq!(levels.refinement(1).guard.unwrap().pulled_back, 0);
}

#[test]
fn an_impossible_floor_ends_in_the_linear_rule() {
    let start = smooth(shapes::five_tet_cube());
    let levels = guarded(start.clone(), Scheme::BoxSpline, 1.0, 2);
    let mut linear = hierarchy(start);
    linear.subdivide(Scheme::Linear).unwrap();
    linear.subdivide(Scheme::Linear).unwrap();
    // The regular tet in the middle ties with its descendants, so nearly all is linear.
    let worst = |mesh: &TetMesh| {
        (0..mesh.tets().len())
            .map(|t| lattice_mean_ratio(mesh.corners(t)))
            .fold(f64::INFINITY, f64::min)
    };
    assert!(worst(&levels.finest().mesh) >= worst(&linear.finest().mesh) - 1e-8);
}

#[test]
fn the_matrix_moves_with_the_points() {
    let levels = guarded(smooth(shapes::regular_tet()), Scheme::BoxSpline, 0.6, 3);
    for transfer in 0..3 {
        let matrix = &levels.refinement(transfer).matrix;
        assert!(levels.affine_defect(transfer, matrix) < 1e-14);
        for row in 0..matrix.rows() {
            assert!((matrix.row(row).1.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn a_jittered_block_stays_above_half_its_quality_under_every_scheme() {
    let mut raw = shapes::kuhn_cube(3).into_raw();
    for (i, x) in raw.points.as_flattened_mut().iter_mut().enumerate() {
        *x += 0.09 * ((i as f64 * 12.9898).sin() * 43758.5453).fract();
    }
    let mesh = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
    let floor = 0.5 * eta_min(&mesh);
    for scheme in Scheme::ALL {
        for options in [
            FeatureOptions::default(),
            FeatureOptions { crease_angle: 180.0, ..Default::default() },
        ] {
            let mut levels = Hierarchy::new(mesh.clone(), &options);
            for _ in 0..3 {
                levels.subdivide(Step { min_quality: Some(floor), ..scheme.into() }).unwrap();
                assert!(
                    eta_min(&levels.finest().mesh) >= floor * (1.0 - 1e-8),
                    "{}",
                    scheme.name()
                );
            }
        }
    }
}

#[test]
fn the_floor_holds_where_each_level_takes_the_shortest_diagonals() {
    // The interpolatory scheme flattens tets of the jittered block in steps, and
    // the diagonal of the next level is not that of the last.
    let mut raw = shapes::kuhn_cube(2).into_raw();
    for (i, x) in raw.points.as_flattened_mut().iter_mut().enumerate() {
        *x += 0.12 * ((i as f64 * 12.9898).sin() * 43758.5453).fract();
    }
    let mesh = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
    let diagonal = Diagonal::ShortestEachLevel;
    let lattices = (0..mesh.tets().len()).map(|t| lattice_mean_ratio(mesh.corners(t)));
    let floor = 0.9 * lattices.fold(1.0, f64::min);
    for scheme in Scheme::ALL {
        let mut levels = Hierarchy::new(mesh.clone(), &FeatureOptions::default());
        for _ in 0..4 {
            let step = Step { diagonal, min_quality: Some(floor), ..scheme.into() };
            levels.subdivide(step).unwrap();
            let eta = eta_min(&levels.finest().mesh);
            assert!(eta >= floor * (1.0 - 1e-8), "{}: {eta} below {floor}", scheme.name());
        }
    }
}
