//! Where vertices inside a solid tend to, against many levels of subdivision.

mod common;

use octruss_mesh::analysis::{LocalMatrix, solid_limit_matrix, star, stars};
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, TetMesh, Topology, prepare, shapes};

fn weights(mesh: &TetMesh, scheme: Scheme, vertex: usize) -> Vec<(u32, f64)> {
    let matrix = solid_limit_matrix(mesh, &Topology::new(mesh.raw()), scheme);
    let (columns, weights) = matrix.row(vertex);
    columns.iter().copied().zip(weights.iter().copied()).collect()
}

#[test]
fn the_regular_interior_has_the_known_mask() {
    let mesh = prepare(shapes::kuhn_cube(4), &FeatureOptions::default());
    let topology = Topology::new(mesh.raw());
    let centre = 62;
    let round = |v: u32| {
        let edge = topology.edge_between(centre, v).unwrap();
        let faces = topology.face_edges().iter().filter(|edges| edges.contains(&edge));
        faces.count()
    };
    let found = weights(&mesh, Scheme::BoxSpline, centre as usize);
    assert_eq!(found.len(), 15);
    let mut counts = [0; 2];
    for (v, weight) in found {
        let known = match v {
            62 => 2.0 / 5.0,
            _ if round(v) == 6 => 1.0 / 20.0,
            _ => 1.0 / 30.0,
        };
        counts[0] += usize::from(known == 1.0 / 20.0);
        counts[1] += usize::from(known == 1.0 / 30.0);
        assert!((weight - known).abs() < 1e-15, "vertex {v}: {weight}, not {known}");
    }
    assert_eq!(counts, [8, 6]);
}

/// A row of the local matrix's high power is the limit.
#[test]
fn rows_are_limits_of_powers_of_local_matrices() {
    let schemes = [Scheme::BoxSpline, Scheme::Averaged, Scheme::LOOP_SOLID];
    let mut levels = Hierarchy::new(shapes::five_tet_cube(), &FeatureOptions::default());
    (0..2).for_each(|_| levels.subdivide(Scheme::Linear).unwrap());
    let refined = levels.finest().mesh.clone();
    let bodies = [stars::stack(5, 3), stars::bipyramid(3), stars::icosahedron(), refined];
    for (mesh, scheme) in bodies.iter().flat_map(|mesh| schemes.map(|scheme| (mesh, scheme))) {
        let topology = Topology::new(mesh.raw());
        let inner = |v: &u32| {
            let faces = topology.faces().iter().enumerate();
            faces.filter(|f| f.1.contains(v)).all(|f| !topology.is_boundary(f.0))
        };
        for vertex in (0..mesh.points().len() as u32).filter(inner).take(12) {
            let local = LocalMatrix::new(mesh, vertex, scheme).unwrap().matrix;
            let power = (0..9).fold(local, |power, _| &power * &power);
            let mut known: Vec<f64> =
                power.row(0).iter().copied().filter(|w| w.abs() > 1e-13).collect();
            let mut found: Vec<f64> =
                weights(mesh, scheme, vertex as usize).into_iter().map(|entry| entry.1).collect();
            known.sort_by(f64::total_cmp);
            found.sort_by(f64::total_cmp);
            assert_eq!(known.len(), found.len(), "{scheme:?} at {vertex}");
            for (a, b) in known.iter().zip(&found) {
                assert!((a - b).abs() < 1e-12, "{scheme:?} at {vertex}: {found:?}, not {known:?}");
            }
            assert!(star(mesh, vertex).unwrap().points().len() <= found.len());
        }
    }
}

#[test]
fn what_keeps_its_place_is_its_own_limit() {
    let mesh = prepare(shapes::kuhn_cube(3), &FeatureOptions::default());
    let topology = Topology::new(mesh.raw());
    let keeps = Scheme::ALL.into_iter().filter(|scheme| scheme.keeps_vertices());
    for scheme in keeps {
        let matrix = solid_limit_matrix(&mesh, &topology, scheme);
        assert_eq!(matrix.apply(mesh.points()), mesh.points());
    }
    // Linear functions stay: a regular interior is its own limit.
    let moved = solid_limit_matrix(&mesh, &topology, Scheme::BoxSpline).apply(mesh.points());
    for (p, q) in moved.as_flattened().iter().zip(mesh.points().as_flattened()) {
        assert!((p - q).abs() < 1e-15);
    }
}
