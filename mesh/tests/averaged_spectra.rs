//! Eigenvalues and invariance of the averaged scheme.

mod common;

use common::{as_ordered, assert_spectrum, at_vertex, hierarchy, on_edge};
use octruss_mesh::analysis::stars::{Marks, bipyramid, edge_ring, icosahedron, octahedron, stack};
use octruss_mesh::reference_tet::MARKING_PERMUTATIONS;
use octruss_mesh::{Scheme, TetMesh, shapes};

#[test]
fn edges_have_their_reference_spectra_whatever_the_marks() {
    // Midpoint of an edge of k tets; computed twice, by a prototype in Python
    // from masks derived exactly from the mean of three box splines, and here.
    let rows: [(u32, &[f64]); 8] = [
        (3, &[1.0, 0.5, 0.317021, 0.317021, 0.273398]),
        (4, &[1.0, 0.5, 0.428122, 0.428122, 0.2533, 0.2533]),
        (5, &[1.0, 0.5, 0.494787, 0.494787, 0.2552, 0.2552]),
        (6, &[1.0, 0.535631, 0.535631, 0.5, 0.317021, 0.317021]),
        (7, &[1.0, 0.561939, 0.561939, 0.5, 0.379401, 0.379401]),
        (8, &[1.0, 0.579716, 0.579716, 0.5, 0.428122, 0.428122]),
        (9, &[1.0, 0.592230, 0.592230, 0.5, 0.465690, 0.465690]),
        (10, &[1.0, 0.601347, 0.601347, 0.5, 0.494787, 0.494787]),
    ];
    for (k, expected) in rows {
        for marks in [Marks::All, Marks::Alternate, Marks::Twist] {
            let local = on_edge(&edge_ring(k, marks), Scheme::Averaged);
            let (first, last) = expected.split_at(4);
            let what = format!("{k} tets, {marks:?}");
            assert_spectrum(&local, first, 1e-6, &what);
            assert_spectrum(&local, &[first, last].concat(), 1e-4, &what);
            assert!(local.spectrum().unwrap().is_separated(), "{what}");
        }
    }
}

#[test]
fn vertices_have_their_reference_spectra() {
    let rows: [(&str, TetMesh, &[f64]); 6] = [
        ("bipyramid 3", bipyramid(3), &[1.0, 0.291667, 0.270833, 0.1875, 0.1875]),
        ("octahedron", octahedron(), &[1.0, 0.291667, 0.291667, 0.291667, 0.270833]),
        ("bipyramid 5", bipyramid(5), &[1.0, 0.356045, 0.356045, 0.291667, 0.270833]),
        ("bipyramid 6", bipyramid(6), &[1.0, 0.395833, 0.395833, 0.291667, 0.270833]),
        ("icosahedron", icosahedron(), &[1.0, 0.478006, 0.478006, 0.478006, 0.270833, 0.208333]),
        ("stack(6, 2)", stack(6, 2), &[1.0, 0.519338, 0.519338, 0.478006, 0.291667, 0.291667]),
    ];
    for (what, mesh, expected) in rows {
        assert_spectrum(&at_vertex(&mesh, 0, Scheme::Averaged), expected, 1e-6, what);
    }
}

#[test]
fn the_result_does_not_depend_on_the_marking() {
    let cube = shapes::five_tet_cube();
    let marked = |choice: [usize; 5]| {
        let tets = cube.tets().iter().zip(choice);
        let tets = tets.map(|(tet, pair)| MARKING_PERMUTATIONS[pair].map(|v| tet[v])).collect();
        let mut levels = hierarchy(as_ordered(cube.points().to_vec(), tets));
        (0..3).for_each(|_| levels.subdivide(Scheme::Averaged).unwrap());
        let mut points = levels.finest().mesh.points().to_vec();
        // Vertices are numbered along the marks; their places are not: compare
        // them sorted, with coordinates equal up to rounding taken as equal.
        let rounded = |p: &[f64; 3]| p.map(|x| (x * 1e9).round() as i64);
        points.sort_by_key(rounded);
        points
    };
    let first = marked([0; 5]);
    assert_eq!(first.len(), 645);
    for choice in [[0, 1, 2, 0, 1], [2, 1, 1, 0, 2]] {
        let other = marked(choice);
        for (p, q) in first.iter().zip(&other) {
            assert!((0..3).all(|k| (p[k] - q[k]).abs() < 1e-14), "{p:?} {q:?}");
        }
    }
}
