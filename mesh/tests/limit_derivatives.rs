//! Derivatives, normals and curvatures of limit surfaces.

mod common;

use common::limit_body::{Body, distance};
use common::random_block::Random;
use octruss_base::vector3::{Vector3, add, dot3, length, scale, subtract};
use octruss_mesh::analysis::stars;
use octruss_mesh::limit::surface::LimitSurface;
use octruss_mesh::{CheckOptions, FeatureOptions, check, prepare, shapes};

/// A place in the middle child, where the surface is a polynomial, drawn
/// `depth` times half the way towards a corner.
fn place(random: &mut Random, depth: i32) -> [f64; 2] {
    let [u, v] = [(); 2].map(|()| 0.3 + 0.08 * random.below(1000) as f64 / 1000.0);
    let corner = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][random.below(3)];
    let size = 0.5f64.powi(depth);
    [corner[0] + size * (u - corner[0]), corner[1] + size * (v - corner[1])]
}

/// The central difference of what is known at a place, along u or v.
fn difference(at: impl Fn([f64; 2]) -> Vector3, uv: [f64; 2], along: usize, h: f64) -> Vector3 {
    let moved = |by: f64| {
        let mut uv = uv;
        uv[along] += by;
        at(uv)
    };
    // Fourth order: quartic polynomials have exact first derivatives.
    let near = scale(8.0, subtract(moved(h), moved(-h)));
    let far = subtract(moved(2.0 * h), moved(-2.0 * h));
    scale(1.0 / (12.0 * h), subtract(near, far))
}

fn assert_derivatives(surface: &LimitSurface, face: u32, uv: [f64; 2], h: f64) {
    let at = |uv| surface.evaluate((face, uv)).unwrap();
    let point = at(uv);
    let second = point.second.unwrap();
    let size = length(point.tangents[0]) + length(point.tangents[1]);
    let bend: f64 = second.iter().map(|d| length(*d)).sum();
    for along in 0..2 {
        let slope = difference(|uv| at(uv).position, uv, along, h);
        let error = distance(slope, point.tangents[along]);
        assert!(error < 1e-8 * size + 4e-15 / h, "face {face} at {uv:?}: {error:e} of {size}");
        for other in 0..2 {
            let slope = difference(|uv| at(uv).tangents[other], uv, along, h);
            let error = distance(slope, second[along + other]);
            assert!(error < 1e-8 * bend + 1e-14 * size / h, "face {face} at {uv:?}: {error:e}");
        }
    }
}

#[test]
fn derivatives_are_those_of_the_positions() {
    let mut random = Random::new(11);
    for n in [3, 4, 6, 7, 9] {
        for one_in in [3, 1000] {
            let body = Body::new(stars::stack(n, 3).into_raw());
            let body = body.with_random_features(&mut random, one_in);
            let surface = body.surface();
            for face in body.surface_faces() {
                for depth in [0, 1, 4, 9] {
                    let uv = place(&mut random, depth);
                    assert_derivatives(&surface, face, uv, 0.5f64.powi(depth + 8));
                }
            }
        }
    }
}

/// Without loss of digits: far down the recursion the derivatives are still
/// those that one level of the same shape shows.
#[test]
fn first_derivatives_keep_their_digits_however_near_a_corner() {
    let body = Body::new(stars::bipyramid(6).into_raw());
    let surface = body.surface();
    // Vertex 1 is a pole with six triangles, where the surface is regular;
    // all others have four.
    let face = body.surface_faces()[0];
    let limits = surface.sector_limits();
    let [pole, ring, _] = body.topology.faces()[face as usize];
    assert_eq!((pole, ring), (1, 3));
    let normal =
        |vertex: u32| limits.iter().find(|l| l.vertex == vertex).unwrap().limit.normal.unwrap();
    for (uv, vertex) in [([1e-17, 2e-17], 1), ([1.0 - 3e-16, 1e-16], 3), ([1e-30, 1e-30], 1)] {
        let near = surface.evaluate((face, uv)).unwrap();
        assert!(distance(near.normal.unwrap(), normal(vertex)) < 1e-5, "{near:?}");
        assert!(length(near.tangents[0]) > 0.0 && length(near.tangents[0]).is_finite());
    }
}

#[test]
fn flat_faces_are_flat() {
    let options = FeatureOptions::default();
    let body =
        Body::new(prepare(shapes::kuhn_box([2, 3, 4], [1.0, 1.0, 1.0]), &options).into_raw());
    let surface = body.surface();
    for face in body.surface_faces() {
        let [a, b, c] = body.topology.faces()[face as usize].map(|v| body.mesh.points[v as usize]);
        let (ab, ac) = (subtract(b, a), subtract(c, a));
        for uv in [[0.2, 0.7], [0.001, 0.002], [0.0, 0.3], [0.999, 1e-9], [0.25, 0.25]] {
            let point = surface.evaluate((face, uv)).unwrap();
            let exact = add(a, add(scale(uv[0], ab), scale(uv[1], ac)));
            assert!(distance(point.position, exact) < 1e-15);
            assert!(
                distance(point.tangents[0], ab) < 1e-13 && distance(point.tangents[1], ac) < 1e-13
            );
            assert!(point.curvatures.unwrap().iter().all(|k| k.abs() < 1e-9));
            // Out of the block: towards the wall on which all corners lie.
            let wall = (0..3).find(|&k| a[k] == b[k] && b[k] == c[k]).unwrap();
            let outward = if a[wall] == 0.0 { -1.0 } else { 1.0 };
            assert!((point.normal.unwrap()[wall] - outward).abs() < 1e-13);
        }
    }
}

#[test]
fn a_ball_bends_away_from_its_outward_normal() {
    let body = Body::new(stars::icosahedron().into_raw());
    let surface = body.surface();
    for face in body.surface_faces() {
        let point = surface.evaluate((face, [0.3, 0.3])).unwrap();
        let radius = length(point.position);
        assert!(dot3(point.normal.unwrap(), point.position) > 0.99 * radius);
        let curvatures = point.curvatures.unwrap();
        assert!(curvatures[0] <= curvatures[1] && curvatures[1] < 0.0);
        assert!(
            curvatures.iter().all(|k| (-k * radius - 1.0).abs() < 0.4),
            "{curvatures:?}, {radius}"
        );
    }
}

/// The masks at a vertex say what the surface tends to towards it, in sectors
/// whose triangles are so few that there is one plane.
#[test]
fn masks_are_the_limits_of_normals() {
    let mut random = Random::new(12);
    let mut kinds = [0; 4];
    for n in 3..=9 {
        for one_in in [3, 6, 1000] {
            let body = Body::new(stars::stack(n, 3).into_raw());
            let body = body.with_random_features(&mut random, one_in);
            let surface = body.surface();
            for sector in surface.sector_limits() {
                let corners = body.topology.faces()[sector.face as usize];
                let i = corners.iter().position(|&v| v == sector.vertex).unwrap();
                let dimension = body.strata.vertex_dimensions[sector.vertex as usize] as usize;
                let darts = body.strata.curve_neighbours(sector.vertex).len();
                if dimension == 0 {
                    continue;
                }
                if i > 0 {
                    continue;
                }
                let near = |depth: i32| {
                    let size = 0.5f64.powi(depth);
                    surface.evaluate((sector.face, [size / 3.0, size / 4.0])).unwrap()
                };
                assert!(distance(near(100).position, sector.limit.position) < 1e-14);
                let Some(normal) = sector.limit.normal else { continue };
                // Beside a single triangle tangents become parallel.
                let found = near(100).normal.or(near(15).normal).unwrap();
                let off = distance(found, normal);
                kinds[dimension + usize::from(dimension == 2 && darts == 1)] += 1;
                assert!(
                    off < 1e-3,
                    "vertex {} (dimension {dimension}, {darts} curves): {off:e}",
                    sector.vertex
                );
            }
        }
    }
    assert!(kinds[1] > 20 && kinds[2] > 15 && kinds[3] > 20, "{kinds:?}");
}

/// At the corners and curves of an L-shaped block, with corners of a quarter, a
/// half and three quarters of a turn, every sector is flat.
#[test]
fn sectors_of_an_angular_block_have_the_normals_of_its_faces() {
    let mut raw = shapes::kuhn_cube(4).into_raw();
    let middle = |tet: &[u32; 4], k: usize| {
        tet.iter().map(|&v| raw.points[v as usize][k]).sum::<f64>() / 4.0
    };
    raw.tets =
        raw.tets.iter().copied().filter(|t| middle(t, 0) < 0.5 || middle(t, 1) < 0.5).collect();
    raw.regions.truncate(raw.tets.len());
    (raw.triangles, raw.groups) = Default::default();
    let mesh = check(raw, &CheckOptions::default()).unwrap().mesh;
    let body = Body::new(prepare(mesh, &FeatureOptions::default()).into_raw());
    let limits = body.surface().sector_limits();
    let mut corners = 0;
    for sector in &limits {
        let point = |v: u32| body.mesh.points[v as usize];
        let [a, b, c] = body.topology.faces()[sector.face as usize].map(point);
        let wall = (0..3).find(|&k| a[k] == b[k] && b[k] == c[k]).unwrap();
        let normal = sector.limit.normal.unwrap();
        // Out of the tet at the face.
        let tet = body.topology.face_tets()[sector.face as usize][0];
        let inner: f64 =
            body.mesh.tets[tet as usize].iter().map(|&v| point(v)[wall] - a[wall]).sum();
        let outward = -inner.signum();
        assert!((normal[wall] - outward).abs() < 1e-13, "{sector:?}");
        assert!(distance(sector.limit.position, point(sector.vertex)) < 1e-15);
        corners += usize::from(body.strata.vertex_dimensions[sector.vertex as usize] == 0);
    }
    // Twelve corners of three faces each.
    assert_eq!(corners, 36);
}
