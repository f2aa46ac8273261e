//! Volumes and qualities over several levels against published values.

mod common;

use common::{hierarchy, smooth};
use octruss_mesh::{
    FeatureOptions, GroupBorders, Hierarchy, Scheme, TetMesh, prepare, quality, shapes,
};

fn eta(mesh: &TetMesh) -> (f64, f64) {
    let summary = quality::summarise(mesh.raw()).unwrap();
    (summary.eta.min, summary.eta.mean)
}

#[test]
fn red_splits_of_the_regular_tet_have_wangs_quality() {
    // Wang's thesis, table 3-6.
    let mut levels = hierarchy(shapes::regular_tet());
    for mean in [0.928571, 0.910714, 0.906250, 0.905134] {
        levels.subdivide(Scheme::Linear).unwrap();
        let (minimum, found) = eta(&levels.finest().mesh);
        assert!((minimum - 0.857143).abs() < 5e-7);
        assert!((found - mean).abs() < 6e-7, "{found} against {mean}");
    }
}

#[test]
fn one_split_of_the_five_tet_cube_is_the_start_of_wangs_table() {
    // Table 3-7 starts from the cube split once: minimum .687230, mean .810330.
    let mut levels = hierarchy(shapes::five_tet_cube());
    levels.subdivide(Scheme::Linear).unwrap();
    let (minimum, mean) = eta(&levels.finest().mesh);
    assert!((minimum - 0.687230).abs() < 5e-7);
    assert!((mean - 0.810330).abs() < 5e-7);
}

#[test]
fn a_smooth_regular_tet_shrinks_as_loops_scheme_says() {
    // The enclosed volume depends on the boundary only: 5/64 at level 1.
    let mut levels = hierarchy(smooth(shapes::regular_tet()));
    let volume = |mesh: &TetMesh| (0..mesh.tets().len()).map(|t| mesh.volume(t)).sum::<f64>();
    let initial = volume(&levels.finest().mesh);
    for ratio in [0.078125, 0.0464172363281, 0.0404442325234, 0.0390700802618, 0.0387338496054] {
        levels.subdivide(Scheme::BoxSpline).unwrap();
        assert!((volume(&levels.finest().mesh) / initial - ratio).abs() < 1e-12);
    }
}

#[test]
fn two_levels_at_once_are_one_level_twice() {
    let options = FeatureOptions::default();
    let mut at_once = Hierarchy::new(shapes::five_tet_cube(), &options);
    at_once.subdivide(Scheme::BoxSpline).unwrap();
    let mut again = Hierarchy::new(at_once.finest().mesh.clone(), &options);
    at_once.subdivide(Scheme::BoxSpline).unwrap();
    again.subdivide(Scheme::BoxSpline).unwrap();
    assert_eq!(&at_once.finest().mesh, &again.finest().mesh);
}

#[test]
fn preparing_twice_changes_nothing() {
    let once = prepare(shapes::five_tet_cube(), &FeatureOptions::default());
    let features = once.features().unwrap();
    assert_eq!((features.creases.len(), features.corners.len()), (12, 0));
    let none = FeatureOptions {
        crease_angle: 180.0,
        group_borders: GroupBorders::None,
        ..FeatureOptions::default()
    };
    assert_eq!(prepare(once.clone(), &none), once);
    assert!(prepare(shapes::five_tet_cube(), &none).features().unwrap().creases.is_empty());
}
