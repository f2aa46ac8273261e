//! Which surfaces can be mirror planes, and what is a crease there.

mod common;

use common::bodies::{bent, turned};
use common::parts::{Part, X0, Y0, Z0, octant, sector};
use common::reflected::Plane;
use octruss_mesh::{
    CheckOptions, FeatureOptions, Hierarchy, MirrorError, Mirrors, RawMesh, Reason, TetMesh, check,
    mirror_candidates, shapes,
};

#[test]
fn curves_on_the_rim_of_a_plane_are_no_creases_for_their_tags() {
    let mut part = Part::new("quarter plate", sector(0.25, [4, 2, 2]), &[X0, Y0]);
    let topology = octruss_mesh::Topology::new(&part.raw);
    let in_plane = |v: &u32| part.raw.points[*v as usize][0].abs() < 1e-9;
    let rim: Vec<[u32; 2]> =
        topology.edges().iter().copied().filter(|ends| ends.iter().all(in_plane)).collect();
    rim.iter().for_each(|&ends| part.raw.edges.push(ends, 3));
    let mesh = check(part.raw, &CheckOptions::default()).unwrap().mesh;
    let mirrors = Mirrors::new(&mesh, &[1, 2]).unwrap();
    let options = FeatureOptions { mirrors, ..Default::default() };
    let levels = Hierarchy::new(mesh, &options);
    let level = levels.coarsest();
    assert_eq!(level.mesh.edges().len(), rim.len());
    let reasons = octruss_mesh::FeatureReasons::new(&level.mesh, &level.topology, Some(&options));
    assert!(
        reasons
            .curves
            .iter()
            .all(|(ends, reason)| { *reason == Reason::Angle && !rim.contains(ends) })
    );
    // Three edges end at each plane; only corners outside are points.
    assert_eq!(reasons.points.len(), 2);
}

#[test]
fn what_is_no_mirror_plane_is_refused() {
    let cube = shapes::kuhn_cube(2);
    let refused = |mesh: &TetMesh, groups: &[i32]| Mirrors::new(mesh, groups).unwrap_err();
    assert!(
        matches!(refused(&cube, &[1, 17]), MirrorError::NoTriangles { group } if group == "17")
    );
    let changed = |change: &dyn Fn(&mut RawMesh)| {
        let mut raw = cube.clone().into_raw();
        change(&mut raw);
        check(raw, &CheckOptions::default()).unwrap().mesh
    };
    // Vertex 12 is the middle of x = 0.
    let bumpy = changed(&|raw| raw.points[12][0] = -0.01);
    let error = refused(&bumpy, &[1]);
    assert!(matches!(error, MirrorError::NotFlat { distance, .. } if distance > 1e-3), "{error}");
    let inner = changed(&|raw| raw.triangles.push([1, 4, 13], 1));
    let error = refused(&inner, &[1]);
    assert!(matches!(error, MirrorError::NotOnBoundary { count: 1, .. }), "{error}");
    let slanted = changed(&|raw| {
        raw.points.iter_mut().for_each(|point| point[1] += 0.01 * point[0]);
    });
    let error = refused(&slanted, &[1, 3]);
    let right = 0.01_f64.atan().to_degrees();
    let is_right = |degrees: f64| (90.0 - degrees - right).abs() < 1e-6;
    assert!(matches!(error, MirrorError::Oblique { degrees, .. } if is_right(degrees)), "{error}");
    assert!(error.to_string().contains("x0") && error.to_string().contains("y0"), "{error}");
    // Only a part of a face is named; the rest has all its vertices on it.
    let partial = changed(&|raw| {
        let first = raw.triangles.tags.iter().position(|&tag| tag == 1).unwrap();
        raw.triangles.tags[first] = 8;
    });
    assert!(matches!(refused(&partial, &[1]), MirrorError::Gap { .. }));
    assert_eq!(Mirrors::new(&partial, &[8, 1, 8]).unwrap().groups(), [1, 8]);
    // An L of three cubes lies on both sides of a face in its corner.
    let mut raw = shapes::kuhn_box([2, 2, 1], [2.0, 2.0, 1.0]).into_raw();
    let points = raw.points.clone();
    let is_cut = |tet: &[u32; 4]| tet.iter().all(|&v| (0..2).all(|k| points[v as usize][k] >= 1.0));
    raw.tets.retain(|tet| !is_cut(tet));
    raw.regions.truncate(raw.tets.len());
    raw.triangles = Default::default();
    let topology = octruss_mesh::Topology::new(&raw);
    for (face, &triangle) in topology.faces().iter().enumerate() {
        let lies_in = triangle.iter().all(|&v| points[v as usize][0] == 1.0);
        if topology.is_boundary(face) && lies_in {
            raw.triangles.push(triangle, 5);
        }
    }
    let bent_back = check(raw, &CheckOptions::default()).unwrap().mesh;
    let error = refused(&bent_back, &[5]);
    assert!(matches!(error, MirrorError::Behind { distance: 1.0, .. }), "{error}");
}

/// Like [`Part::new`], but each side of a plate with its own surface.
fn with_sides(mesh: TetMesh, planes: &[Plane]) -> TetMesh {
    let mut raw = Part::new("", mesh, planes).raw;
    for at in 0..raw.triangles.len() {
        let vertices = raw.triangles.simplices[at];
        let all_at = |z: f64| vertices.iter().all(|&v| raw.points[v as usize][2] == z);
        let side = if all_at(0.0) { 20 } else { 21 };
        if all_at(0.0) || all_at(1.0) {
            raw.triangles.tags[at] = side;
        }
    }
    check(raw, &CheckOptions::default()).unwrap().mesh
}

#[test]
fn planes_that_round_surfaces_meet_are_proposed() {
    let plate = sector(0.25, [6, 3, 2]);
    assert_eq!(mirror_candidates(&with_sides(plate.clone(), &[X0, Y0])), [1, 2]);
    let part = Part::new("octant", octant(2), &[X0, Y0, Z0]).raw;
    let octant = check(part, &CheckOptions::default()).unwrap().mesh;
    assert_eq!(mirror_candidates(&octant), [1, 2, 3]);
    // Cells that take up turns of 2 to 1, in turns.
    let uneven = bent([6, 2, 1], |[x, y, z]| {
        let turn = (x + if x % 2.0 == 1.0 { 1.0 / 3.0 } else { 0.0 }) / 24.0;
        turned(turn, 1.0 + y / 2.0, z)
    });
    assert_eq!(mirror_candidates(&with_sides(uneven, &[X0, Y0])), [1, 2]);
    // Flat everywhere, inclined, or cut off a bulge beside its middle.
    assert!(mirror_candidates(&shapes::kuhn_cube(2)).is_empty());
    let of_base = |cells, shape: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let raw = Part::new("", bent(cells, shape), &[Z0]).raw;
        mirror_candidates(&check(raw, &CheckOptions::default()).unwrap().mesh)
    };
    let narrowed = |by: fn(f64) -> f64| {
        of_base([4, 4, 4], &move |[x, y, z]| [(x - 2.0) * by(z), (y - 2.0) * by(z), z])
    };
    assert!(narrowed(|z| 1.0 - 0.05 * z).is_empty());
    assert!(narrowed(|z| 1.0 - 0.02 * (z + 1.0) * (z + 1.0)).is_empty());
    assert_eq!(narrowed(|z| 1.0 - 0.02 * z * z), [3]);
}
