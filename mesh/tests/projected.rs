//! Levels whose boundary vertices are put onto the limit.

mod common;

use common::bodies::{ball, pipe as pipe_of};
use octruss_mesh::{
    CurveEnds, FeatureOptions, Hierarchy, Scheme, Step, TetMesh, guard, limit_matrix,
};

const SCHEMES: [Scheme; 3] = [Scheme::BoxSpline, Scheme::Averaged, Scheme::LOOP_SOLID];

/// With creases that end nowhere and, since it is cut open, corners.
fn pipe() -> TetMesh {
    pipe_of([12, 1, 2], [1.5, 2.0], 3.0)
}

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
        let distances = projected.limit_distances(2, step);
        assert!(distances.largest < 1e-12, "{scheme:?}: {distances:?}");
    }
}

#[test]
fn a_step_that_interpolates_goes_on_with_the_surface_of_a_projected_level() {
    let plain = Step::from(Scheme::BoxSpline);
    let projected = levels(ball(2), Step { project_limit: true, ..plain }, 1);
    let mut further = Hierarchy::new(projected.into_finest().mesh, &FeatureOptions::default());
    // With the ends of curves that are recorded, not those that it would choose itself.
    let through = Step { interpolate: true, ..plain };
    further.subdivide(through).unwrap();
    let distances = further.limit_distances(1, through);
    assert!(distances.input_largest < 1e-12, "{distances:?}");
}

#[test]
fn projecting_every_level_leads_to_the_same_surface() {
    let step = Step { project_limit: true, ..Scheme::BoxSpline.into() };
    let once = levels(pipe(), step, 2);
    let mut twice = Hierarchy::new(pipe(), &FeatureOptions::default());
    (0..2).for_each(|_| twice.subdivide(step).unwrap());
    let strata = |level: &octruss_mesh::Level| {
        let features = level.mesh.features().unwrap();
        octruss_mesh::Strata::new(level.mesh.raw(), &level.topology, features)
    };
    let dimensions = strata(once.finest()).vertex_dimensions;
    let pairs = once.finest().mesh.points().iter().zip(twice.finest().mesh.points());
    for ((a, b), _) in pairs.zip(dimensions).filter(|(_, dimension)| *dimension < 3) {
        assert!(largest_distance(&[*a], &[*b]) < 1e-12);
    }
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
