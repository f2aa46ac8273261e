//! Levels whose boundary vertices are put onto the limit.

mod common;

use common::bodies::ball;
use octruss_mesh::{
    CurveEnds, FeatureOptions, Hierarchy, Scheme, Step, TetMesh, guard, limit_matrix,
};

const SCHEMES: [Scheme; 3] = [Scheme::BoxSpline, Scheme::Averaged, Scheme::LOOP_SOLID];

fn levels(mesh: TetMesh, step: Step, count: usize) -> Hierarchy {
    let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
    for number in 1..=count {
        let project_limit = step.project_limit && number == count;
        levels.subdivide(Step { project_limit, ..step }).unwrap();
    }
    levels
}

fn largest_distance(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn the_boundary_is_on_the_limit_and_the_rows_lead_there() {
    for scheme in SCHEMES {
        let step = Step { project_limit: true, ..scheme.into() };
        let [plain, projected] = [scheme.into(), step].map(|step| levels(ball(2), step, 2));
        let level = plain.finest();
        let limit = limit_matrix(&level.mesh, &level.topology, scheme, CurveEnds::Fixed);
        let strata = octruss_mesh::Strata::new(
            level.mesh.raw(),
            &level.topology,
            level.mesh.features().unwrap(),
        );
        let limits = limit.apply(level.mesh.points());
        let points = projected.finest().mesh.points();
        for (v, &dimension) in strata.vertex_dimensions.iter().enumerate() {
            let expected = if dimension < 3 { limits[v] } else { level.mesh.points()[v] };
            assert!(largest_distance(&[expected], &[points[v]]) < 1e-12, "{scheme:?}, {v}");
        }
        let refinement = projected.refinement(1);
        let carried = refinement.matrix.apply(projected.levels()[1].mesh.points());
        assert!(largest_distance(&carried, points) < 1e-12);
        assert!(refinement.interpolation.is_none());
    }
}

#[test]
fn a_step_that_interpolates_goes_on_with_the_surface_of_a_projected_level() {
    let plain = Step::from(Scheme::BoxSpline);
    let projected = levels(ball(2), Step { project_limit: true, ..plain }, 1);
    let mut further = Hierarchy::new(projected.into_finest().mesh, &FeatureOptions::default());
    let through = Step { interpolate: true, curve_ends: Some(CurveEnds::Fixed), ..plain };
    further.subdivide(through).unwrap();
    let distances = further.limit_distances(1, through);
    assert!(distances.input_largest < 1e-12, "{distances:?}");
}

#[test]
fn with_interpolation_all_boundary_vertices_are_on_the_limit() {
    let mesh = ball(2);
    let floor = Some(guard::usual_floor(&mesh));
    let through = Step { interpolate: true, min_quality: floor, ..Scheme::BoxSpline.into() };
    let [near, on] = [false, true].map(|project_limit| {
        let step = Step { project_limit, ..through };
        levels(mesh.clone(), step, 2).limit_distances(2, through)
    });
    assert!(on.largest < 1e-8 && on.largest < 0.1 * near.largest, "{near:?} {on:?}");
}

#[test]
fn schemes_that_keep_vertices_have_nowhere_to_go() {
    for scheme in [Scheme::Linear, Scheme::INTERPOLATORY] {
        let step = Step { project_limit: true, ..scheme.into() };
        let [plain, projected] = [scheme.into(), step].map(|step| levels(ball(1), step, 1));
        assert_eq!(plain.finest().mesh.points(), projected.finest().mesh.points());
    }
}
