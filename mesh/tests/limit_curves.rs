//! Limits of curves: exact for every parameter.

mod common;

use common::limit_body::{Body, distance};
use octruss_mesh::analysis::stars;
use octruss_mesh::limit::LimitError;
use octruss_mesh::limit::curve::LimitCurves;
use octruss_mesh::limit::surface::LimitSurface;
use octruss_mesh::{Features, RawMesh};

/// A star with six vertices round its equator, that is a crease in whole or in
/// part.
fn equator(edges: usize) -> Body {
    let mut mesh: RawMesh = stars::bipyramid(6).into_raw();
    let ring = |i: usize| 3 + (i % 6) as u32;
    let mut creases: Vec<[u32; 2]> = (0..edges).map(|i| [ring(i), ring(i + 1)]).collect();
    creases.iter_mut().for_each(|edge| edge.sort_unstable());
    creases.sort_unstable();
    mesh.features = Some(Features { creases, ..Features::default() });
    Body::new(mesh)
}

fn curves<'a>(body: &'a Body, points: &'a [[f64; 3]]) -> LimitCurves<'a> {
    LimitCurves::new(&body.topology, &body.strata, points).unwrap()
}

/// Cubic B-splines reproduce quadratics: controls i² − 1/3 make t².
#[test]
fn a_closed_curve_reproduces_quadratics() {
    let body = equator(6);
    let mut points = vec![[0.0; 3]; body.mesh.points.len()];
    for (i, v) in (0..5).zip(3..8) {
        points[v] = [f64::from(i), f64::from(i * i) - 1.0 / 3.0, 2.0];
    }
    for (edge, start) in [([4, 5], 1.0), ([5, 6], 2.0)] {
        let edge = body.topology.edge_between(edge[0], edge[1]).unwrap();
        for t in [0.0, 0.125, 0.5, 0.9, 1.0] {
            let point = curves(&body, &points).evaluate(edge, t).unwrap();
            let x = start + t;
            assert!(distance(point.position, [x, x * x, 2.0]) < 1e-14);
            assert!(distance(point.first, [1.0, 2.0 * x, 0.0]) < 1e-14);
            assert!(distance(point.second, [0.0, 2.0, 0.0]) < 1e-14);
            let curvature = 2.0 / (1.0 + 4.0 * x * x).powf(1.5);
            assert!((point.curvature().unwrap() - curvature).abs() < 1e-14);
        }
    }
}

/// Open curves have fixed corners; a corner's curve is a spline up to it.
#[test]
fn an_open_curve_ends_in_its_corners_as_subdivision_says() {
    let mut body = equator(3);
    body.mesh.features.as_mut().unwrap().corners = vec![3, 6];
    let body = Body::new(body.mesh);
    let points = &body.mesh.points;
    // The polygon 3, 4, 5, 6, subdivided 25 times near its first vertices.
    let mut polygon: Vec<[f64; 3]> = (3..7).map(|v| points[v]).collect();
    let mix = |a: [f64; 3], b: [f64; 3], w: f64| [0, 1, 2].map(|k| (1.0 - w) * a[k] + w * b[k]);
    let first = body.topology.edge_between(3, 4).unwrap();
    for level in 0..25 {
        let middles: Vec<[f64; 3]> = polygon.windows(2).map(|e| mix(e[0], e[1], 0.5)).collect();
        let mut fine = vec![polygon[0]];
        for i in 1..polygon.len() {
            fine.push(middles[i - 1]);
            if i + 1 < polygon.len() {
                fine.push(mix(mix(middles[i - 1], middles[i], 0.5), polygon[i], 0.5));
            } else {
                fine.push(polygon[i]);
            }
        }
        fine.truncate(8);
        polygon = fine;
        let t = 0.5f64.powi(level + 1);
        let found = curves(&body, points).evaluate(first, t).unwrap();
        let vertex = [0, 1, 2].map(|k| (polygon[0][k] + 4.0 * polygon[1][k] + polygon[2][k]) / 6.0);
        assert!(distance(found.position, vertex) < 1e-15);
    }
    let end = curves(&body, points).evaluate(first, 0.0).unwrap();
    assert!(distance(end.position, points[3]) < 1e-16 && distance(end.second, [0.0; 3]) < 1e-15);
}

/// A surface ends in its curves: both evaluations agree along an edge.
#[test]
fn surfaces_meet_their_curves() {
    let body = equator(6);
    let surface =
        LimitSurface::new(&body.mesh, &body.topology, &body.strata, &body.mesh.points).unwrap();
    for [a, b, pole] in [[3, 4, 1], [4, 5, 2], [3, 8, 1]] {
        let face = body.topology.face_of([a, b, pole]).unwrap();
        let edge = body.topology.edge_between(a, b).unwrap();
        for t in [0.0, 0.3, 0.5, 0.77, 1.0] {
            // The pole comes first, the edge opposite it.
            let on_surface = surface.evaluate((face, [1.0 - t, t])).unwrap();
            let on_curve = curves(&body, &body.mesh.points).evaluate(edge, t).unwrap();
            assert!(distance(on_surface.position, on_curve.position) < 1e-15);
            if t > 0.0 && t < 1.0 {
                let [u, v] = on_surface.tangents;
                assert!(distance([0, 1, 2].map(|k| v[k] - u[k]), on_curve.first) < 1e-13);
            }
        }
    }
}

#[test]
fn what_is_no_curve_is_refused() {
    let body = equator(2);
    let points = &body.mesh.points;
    let at = |a, b, t| curves(&body, points).evaluate(body.topology.edge_between(a, b).unwrap(), t);
    let smooth = body.topology.edge_between(1, 3).unwrap();
    assert_eq!(at(1, 3, 0.5), Err(LimitError::NotOnCurve { edge: smooth }));
    let dart = body.topology.edge_between(3, 4).unwrap();
    assert_eq!(at(3, 4, 0.5), Err(LimitError::EndsInDart { edge: dart, vertex: 3 }));
    assert_eq!(at(3, 4, 1.5), Err(LimitError::OutsideEdge { t: 1.5 }));
    assert!(matches!(curves(&body, points).evaluate(999, 0.5), Err(LimitError::NoEdge { .. })));
    assert!(matches!(
        LimitCurves::new(&body.topology, &body.strata, &points[1..]),
        Err(LimitError::Points { points: 8, vertices: 9 })
    ));
}
