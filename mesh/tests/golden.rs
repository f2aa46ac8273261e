//! Whole meshes per scheme and level, stored as text: a weight cannot change
//! unseen, nor can a number or an order.
//!
//! The weights behind them are compared with a slow reference elsewhere; the
//! files were written once. Coordinates are compared to 1e-13, so that a change
//! in the order of a sum is no change of a mesh.

mod common;

use std::fmt::Write;
use std::path::Path;

use common::{hierarchy, smooth};
use octruss_mesh::analysis::stars::{Marks, edge_ring};
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, TetMesh, shapes};

fn as_text(mesh: &TetMesh) -> String {
    let mut text = String::new();
    for [x, y, z] in mesh.points() {
        writeln!(text, "v {x:?} {y:?} {z:?}").unwrap();
    }
    for ([a, b, c, d], region) in mesh.tets().iter().zip(mesh.regions()) {
        writeln!(text, "t {a} {b} {c} {d} {region}").unwrap();
    }
    for ([a, b, c], tag) in mesh.triangles().iter() {
        writeln!(text, "f {a} {b} {c} {tag}").unwrap();
    }
    for [a, b] in &mesh.features().unwrap().creases {
        writeln!(text, "c {a} {b}").unwrap();
    }
    text
}

fn compare(name: &str, mesh: &TetMesh) {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name).with_extension("txt");
    let golden =
        std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let text = as_text(mesh);
    assert_eq!(text.lines().count(), golden.lines().count(), "{name}");
    for (number, (found, expected)) in text.lines().zip(golden.lines()).enumerate() {
        let same = found == expected || (expected.starts_with("v ") && close(found, expected));
        assert!(same, "{name}:{}: {found} against {expected}", number + 1);
    }
}

fn close(found: &str, expected: &str) -> bool {
    let numbers =
        |line: &str| -> Vec<f64> { line[2..].split(' ').map(|x| x.parse().unwrap()).collect() };
    numbers(found).iter().zip(numbers(expected)).all(|(p, q)| (p - q).abs() < 1e-13)
}

/// Compares the levels 1 and 2 under both schemes.
fn compare_levels(name: &str, start: &Hierarchy) {
    for scheme in [Scheme::Linear, Scheme::BoxSpline] {
        let mut levels = start.clone();
        for level in 1..=2 {
            levels.subdivide(scheme).unwrap();
            compare(&format!("{name}-{}-{level}", scheme.name()), &levels.finest().mesh);
        }
    }
}

#[test]
fn a_smooth_regular_tet() {
    compare_levels("tet-smooth", &hierarchy(smooth(shapes::regular_tet())));
}

#[test]
fn a_five_tet_cube_with_sharp_edges() {
    compare_levels(
        "cube-sharp",
        &Hierarchy::new(shapes::five_tet_cube(), &FeatureOptions::default()),
    );
}

#[test]
fn a_ring_of_five_tets_with_conflicting_marks() {
    compare_levels("ring-twist", &hierarchy(edge_ring(5, Marks::Twist)));
}

#[test]
fn a_block_of_two_regions_with_tagged_sides() {
    let mut raw = shapes::kuhn_box([2, 1, 1], [2.0, 1.0, 1.0]).into_raw();
    raw.regions = (0..12).map(|tet| if tet < 6 { 4 } else { 5 }).collect();
    let mesh = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
    compare_levels("two-regions", &Hierarchy::new(mesh, &FeatureOptions::default()));
}
