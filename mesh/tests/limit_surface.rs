//! Limits of surfaces at any place of any triangle, against subdividing there
//! fifty times more.

mod common;

use common::limit_body::{Body, distance};
use common::random_block::{Random, blocks};
use common::slow_surface::SlowSurface;
use octruss_mesh::analysis::stars;
use octruss_mesh::limit::{LimitError, surface::LimitSurface};
use octruss_mesh::{
    CheckOptions, FeatureOptions, Features, Hierarchy, RawMesh, Scheme, check, prepare, shapes,
};
use proptest::prelude::*;

/// The barycentric coordinates of a child's corners.
fn child_corners([a, b, c]: [[f64; 2]; 3], child: usize) -> [[f64; 2]; 3] {
    let middle = |p: [f64; 2], q: [f64; 2]| [0, 1].map(|k| 0.5 * (p[k] + q[k]));
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]][child]
}

/// Goes to random triangles, `depth` levels down at most, and compares the
/// limits at their corners.
fn assert_agrees(body: &Body, random: &mut Random, paths: usize, depth: usize) {
    let surface = body.surface();
    let touching = surface.touching();
    let mut faces = body.surface_faces();
    faces.retain(|&face| {
        let corners = body.topology.faces()[face as usize];
        let touches = corners.iter().find(|&v| touching.contains(v));
        let refused = touches.map(|_| surface.position((face, [0.2, 0.2])).is_err());
        refused != Some(true)
    });
    for path in 0..paths {
        let face = *faces.get(path).unwrap_or(&faces[random.below(faces.len())]);
        let mut slow = SlowSurface::new(&body.topology, &body.strata, &body.mesh.points, face);
        let mut corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        for _ in 0..random.below(depth + 1) {
            let child = random.below(4);
            slow.step(child);
            corners = child_corners(corners, child);
        }
        for (i, uv) in corners.into_iter().enumerate() {
            let mut there = slow.clone();
            (0..50).for_each(|_| there.step(i));
            let limit = there.corner(i);
            let found = surface.position((face, uv)).unwrap();
            assert!(
                distance(found, limit) < 1e-13,
                "face {face} at {uv:?}: {found:?}, not {limit:?}"
            );
            let point = surface.evaluate((face, uv)).unwrap();
            assert_eq!(point.position, found);
        }
    }
}

#[test]
fn smooth_surfaces_agree_with_subdivision_at_all_valences() {
    let mut random = Random::new(1);
    for n in 3..=9 {
        assert_agrees(&Body::new(stars::bipyramid(n).into_raw()), &mut random, 40, 8);
        assert_agrees(&Body::new(stars::stack(n, 3).into_raw()), &mut random, 60, 8);
    }
}

#[test]
fn creased_and_smooth_blocks_agree_with_subdivision() {
    let mut random = Random::new(2);
    for crease_angle in [40.0, 180.0] {
        let options = FeatureOptions { crease_angle, ..FeatureOptions::default() };
        let body =
            Body::new(prepare(shapes::kuhn_box([2, 3, 2], [1.0, 2.0, 0.7]), &options).into_raw());
        assert_agrees(&body, &mut random, 150, 8);
    }
}

#[test]
fn any_pattern_of_creases_and_corners_agrees_with_subdivision() {
    let mut random = Random::new(3);
    for one_in in [2, 4, 8, 16] {
        for n in [3, 5, 6, 8] {
            let body =
                Body::new(stars::stack(n, 3).into_raw()).with_random_features(&mut random, one_in);
            assert_agrees(&body, &mut random, 60, 8);
        }
    }
}

#[test]
fn interfaces_and_where_they_meet_the_boundary_agree_with_subdivision() {
    let mut random = Random::new(4);
    let mut mesh = shapes::kuhn_cube(3).into_raw();
    for (tet, region) in mesh.tets.iter().zip(&mut mesh.regions) {
        let middle: f64 = tet.iter().map(|&v| mesh.points[v as usize][0]).sum::<f64>() / 4.0;
        *region = i32::from(middle > 0.4);
    }
    mesh.points
        .as_flattened_mut()
        .iter_mut()
        .for_each(|x| *x += 0.0001 * random.below(1000) as f64);
    mesh.features = Some(Features::default());
    let body = Body::new(mesh);
    assert_agrees(&body, &mut random, 200, 8);
}

/// Every dyadic place of the input is a vertex of the third level of the solid.
#[test]
fn levels_of_the_solid_have_the_same_limit() {
    let mut raw = shapes::kuhn_cube(1).into_raw();
    raw.points[5] = [1.3, -0.1, 0.8];
    for crease_angle in [60.0, 180.0] {
        let options = FeatureOptions { crease_angle, ..FeatureOptions::default() };
        let mesh = check(raw.clone(), &CheckOptions::default()).unwrap().mesh;
        let mut levels = Hierarchy::new(mesh, &options);
        (0..3).for_each(|_| levels.subdivide(Scheme::BoxSpline).unwrap());
        let body = Body::new(levels.coarsest().mesh.raw().clone());
        let fine = Body::new(levels.finest().mesh.raw().clone());
        let limits = fine.surface().sector_limits();
        for face in body.surface_faces() {
            for (i, j) in (0..=8).flat_map(|i| (0..=8 - i).map(move |j| (i, j))) {
                let uv = [i, j].map(|x| f64::from(x) / 8.0);
                let found = body.surface().position((face, uv)).unwrap();
                let away = limits.iter().map(|fine| distance(fine.limit.position, found));
                let least = away.fold(f64::INFINITY, f64::min);
                assert!(least < 1e-14, "face {face} at {uv:?}: {least:e} from all vertices");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn random_blocks_agree_with_subdivision(mesh in blocks(), seed: u64, crease_angle in prop::sample::select(vec![40.0, 100.0, 180.0])) {
        let options = FeatureOptions { crease_angle, ..FeatureOptions::default() };
        let body = Body::new(prepare(mesh, &options).into_raw());
        let mut random = Random::new(seed);
        assert_agrees(&body, &mut random, 30, 8);
        let body = body.with_random_features(&mut random, 6);
        assert_agrees(&body, &mut random, 30, 8);
    }
}

#[test]
fn wrong_places_are_refused_with_one_message() {
    let body = Body::new(prepare(shapes::kuhn_cube(2), &FeatureOptions::default()).into_raw());
    let surface = body.surface();
    let face = body.surface_faces()[0];
    let inner = (0..).find(|&f: &u32| !body.strata.is_surface[f as usize]).unwrap();
    let middle = [0.3, 0.3];
    assert_eq!(surface.position((inner, middle)), Err(LimitError::NotOnSurface { face: inner }));
    assert!(matches!(surface.position((9999, middle)), Err(LimitError::NoFace { .. })));
    for [u, v] in [[-0.1, 0.2], [0.2, -1e-9], [0.6, 0.5], [f64::NAN, 0.1]] {
        assert!(matches!(surface.evaluate((face, [u, v])), Err(LimitError::Outside { .. })));
    }
    let few = &body.mesh.points[1..];
    let refused = LimitSurface::new(&body.mesh, &body.topology, &body.strata, few);
    assert_eq!(refused.err(), Some(LimitError::Points { points: 26, vertices: 27 }));
}

#[test]
fn a_smooth_vertex_at_which_surfaces_touch_is_named() {
    let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mirrored = points[1..].iter().map(|p| p.map(|x| -x));
    let mut mesh = RawMesh {
        points: points.iter().copied().chain(mirrored).collect(),
        tets: vec![[0, 1, 2, 3], [0, 5, 4, 6]],
        regions: vec![0; 2],
        features: Some(Features::default()),
        ..RawMesh::default()
    };
    let body = Body::new(mesh.clone());
    let surface = body.surface();
    let [beside, away] = [[0, 1, 2], [1, 2, 3]].map(|face| body.topology.face_of(face).unwrap());
    assert_eq!(surface.touching(), [0]);
    assert_eq!(surface.position((beside, [0.3, 0.3])), Err(LimitError::NotADisc { vertex: 0 }));
    assert!(surface.position((away, [0.3, 0.3])).is_ok());
    assert!(surface.sector_limits().iter().all(|limit| limit.vertex != 0));
    // As the message says.
    mesh.features.as_mut().unwrap().corners.push(0);
    let body = Body::new(mesh);
    assert!(body.surface().position((beside, [0.3, 0.3])).is_ok());
}
