//! The masks of the schemes on their regular lattices, as exact rationals by
//! class of symmetry.

mod common;

use common::hierarchy;
use octruss_mesh::{Scheme, TetMesh, shapes, subdivision_matrix};

/// (a class of places, how many there are, the weight there).
type Class<K> = (K, usize, f64);

/// Compares what the field that is 1 at one vertex becomes after a step with
/// the classes: `class` names that of a new vertex by its offset from the vertex.
fn compare<K: PartialEq + std::fmt::Debug>(
    mesh: TetMesh,
    scheme: Scheme,
    vertex: u32,
    class: impl Fn([f64; 3]) -> K,
    expected: &[Class<K>],
) {
    let mut levels = hierarchy(mesh);
    let matrix = subdivision_matrix(&levels.coarsest().mesh, &levels.coarsest().topology, scheme);
    levels.subdivide(Scheme::Linear).unwrap();
    let centre = levels.coarsest().mesh.points()[vertex as usize];
    let mut counts = vec![0; expected.len()];
    for (row, point) in levels.finest().mesh.points().iter().enumerate() {
        let (columns, weights) = matrix.row(row);
        let weight = columns.binary_search(&vertex).map_or(0.0, |at| weights[at]);
        let place = class([0, 1, 2].map(|k| point[k] - centre[k]));
        match expected.iter().position(|(known, ..)| *known == place) {
            Some(at) => {
                counts[at] += 1;
                assert!((weight - expected[at].2).abs() < 1e-16, "{place:?}: {weight}");
            }
            None => assert_eq!(weight, 0.0, "{place:?}"),
        }
    }
    assert_eq!(counts, expected.iter().map(|class| class.1).collect::<Vec<_>>());
    let sum: f64 = expected.iter().map(|(_, count, weight)| *count as f64 * weight).sum();
    assert!((sum - 8.0).abs() < 1e-14);
}

/// On the Kuhn lattice, with cells of size 1: barycentric-like coordinates with
/// respect to e1, e2, e3 and e4 = −(e1 + e2 + e3), in half steps, sorted; of a
/// place and its mirror image the smaller.
fn kuhn_class(offset: [f64; 3]) -> [i32; 4] {
    let class = |sign: f64| {
        let [a, b, c] = offset.map(|x| (2.0 * sign * x).round() as i32);
        let low = a.min(b).min(c).min(0);
        let mut sorted = [a - low, b - low, c - low, -low];
        sorted.sort();
        sorted
    };
    class(1.0).min(class(-1.0))
}

/// A block of 6³ unit cells, without creases, and the vertex in its middle.
fn kuhn_block() -> (TetMesh, u32) {
    let mesh = common::smooth(shapes::kuhn_box([6; 3], [6.0; 3]));
    let middle = mesh.points().iter().position(|p| *p == [3.0; 3]).unwrap() as u32;
    (mesh, middle)
}

#[test]
fn the_box_spline_has_its_mask() {
    let (mesh, middle) = kuhn_block();
    let classes = [
        ([0, 0, 0, 0], 1, 9.0 / 16.0),
        ([0, 0, 0, 1], 8, 5.0 / 16.0),
        ([0, 0, 1, 1], 6, 1.0 / 4.0),
        ([0, 0, 1, 2], 24, 1.0 / 16.0),
        ([0, 1, 1, 2], 12, 1.0 / 8.0),
        ([0, 0, 0, 2], 8, 1.0 / 32.0),
        ([0, 0, 2, 2], 6, 1.0 / 32.0),
    ];
    compare(mesh, Scheme::BoxSpline, middle, kuhn_class, &classes);
}

#[test]
fn the_interpolatory_scheme_has_its_mask() {
    let (mesh, middle) = kuhn_block();
    let classes = [
        ([0, 0, 0, 0], 1, 1.0),
        ([0, 0, 0, 1], 8, 1.0 / 2.0),
        ([0, 0, 1, 1], 6, 1.0 / 2.0),
        ([0, 0, 1, 2], 24, 1.0 / 16.0),
        ([0, 1, 1, 2], 12, 1.0 / 16.0),
        ([0, 1, 1, 3], 24, -1.0 / 16.0),
        ([0, 0, 1, 3], 24, -1.0 / 32.0),
    ];
    compare(mesh, Scheme::INTERPOLATORY, middle, kuhn_class, &classes);
}

#[test]
fn the_averaged_scheme_has_its_mask() {
    // The truss of a regular tet split three times; its vertices are the points
    // with an even sum of coordinates, in units of 1/4; offsets in half units.
    let mut levels = hierarchy(shapes::regular_tet());
    (0..3).for_each(|_| levels.subdivide(Scheme::Linear).unwrap());
    let mesh = levels.finest().mesh.clone();
    let middle = mesh.points().iter().position(|p| *p == [0.0; 3]).unwrap() as u32;
    let class = |offset: [f64; 3]| {
        let mut sorted = offset.map(|x| (8.0 * x.abs()).round() as i32);
        sorted.sort();
        sorted
    };
    let classes = [
        ([0, 0, 0], 1, 9.0 / 16.0),
        ([0, 1, 1], 12, 7.0 / 24.0),
        ([0, 0, 2], 6, 1.0 / 6.0),
        ([1, 1, 2], 24, 1.0 / 12.0),
        ([0, 2, 2], 12, 1.0 / 32.0),
        ([0, 1, 3], 24, 1.0 / 48.0),
        ([0, 0, 4], 6, 1.0 / 96.0),
    ];
    compare(mesh, Scheme::Averaged, middle, class, &classes);
}
