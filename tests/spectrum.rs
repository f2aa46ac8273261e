//! `octruss spectrum` and `octruss basis` as a user or a script meets them.

mod common;

use std::path::Path;

use common::{code, octruss, sample, stderr, succeed};
use octruss_mesh::shapes::kuhn_box;
use octruss_meshio::{Dataset, Values, read, write};
use serde_json::Value;

fn spectrum(folder: &Path, arguments: &[&str]) -> Value {
    let arguments = [&["spectrum", "--json"], arguments].concat();
    serde_json::from_str(&succeed(folder, &arguments)).unwrap()
}

fn moduli(answer: &Value) -> Vec<f64> {
    let part = |value: &Value, i: usize| value[i].as_f64().unwrap();
    let eigenvalues = answer["eigenvalues"].as_array().unwrap();
    eigenvalues.iter().map(|value| part(value, 0).hypot(part(value, 1))).collect()
}

/// A block of 4³ unit Kuhn cells as a file, and its middle vertex's number.
fn block(folder: &Path) -> u32 {
    let mesh = kuhn_box([4; 3], [4.0; 3]).into_raw();
    let middle = mesh.points.iter().position(|p| *p == [2.0; 3]).unwrap();
    write(&folder.join("block.vtu"), &Dataset { mesh, ..Dataset::default() }).unwrap();
    middle as u32
}

#[test]
fn named_stars_have_published_eigenvalues() {
    let here = Path::new(".");
    // Chang's thesis, table 4.2, rows 12, 6, 9, 17; table 4.3, k = 5.
    let rows: [(&[&str], &[f64]); 5] = [
        (&["--vertex", "icosahedron"], &[1.0, 0.480205, 0.480205, 0.480205, 0.25]),
        (&["--vertex", "octahedron"], &[1.0, 0.3125, 0.25, 0.25, 0.25]),
        (&["--vertex", "bipyramid:7"], &[1.0, 0.405872, 0.405872, 0.3125, 0.26545]),
        (&["--vertex", "stack:5,3"], &[1.0, 0.571212, 0.511703, 0.511703, 0.371472]),
        (&["--edge", "5", "--marks", "twist"], &[1.0, 0.480205, 0.480205, 0.480205, 0.25]),
    ];
    for (arguments, expected) in rows {
        let answer = spectrum(here, arguments);
        assert_eq!(answer["rings"], 1);
        assert_eq!(answer["verdict"]["convergent"], true);
        for (found, expected) in moduli(&answer).iter().zip(expected) {
            assert!((found - expected).abs() < 3e-6, "{arguments:?}: {found} {expected}");
        }
    }
}

#[test]
fn the_verdict_is_printed_for_readers() {
    let here = Path::new(".");
    let text = succeed(here, &["spectrum", "--edge", "8"]);
    for part in ["one-ring block, 27 rows", "λ1     0.611117", "convergent          yes"] {
        assert!(text.contains(part), "{part} in\n{text}");
    }
    assert!(text.contains("characteristic map  not applicable: λ3 is not larger than λ4"));
    let text = succeed(here, &["spectrum", "--vertex", "icosahedron", "--scheme", "averaged"]);
    assert!(text.contains("regular yes, injective yes (10240 tets)"), "{text}");
    let complex = succeed(here, &["spectrum", "--edge", "4", "--marks", "alternate"]);
    assert!(complex.contains("0.233282 +0.032762 i"), "{complex}");
}

#[test]
fn a_vertex_of_a_mesh_is_analysed_and_its_map_written() {
    let folder = tempfile::tempdir().unwrap();
    let middle = block(folder.path());
    let place = format!("block.vtu:{middle}");
    let answer = spectrum(folder.path(), &["--vertex", &place, "--map", "map.vtu"]);
    for (found, expected) in moduli(&answer).iter().zip([1.0, 0.5, 0.5, 0.5, 0.25]) {
        assert!((found - expected).abs() < 1e-6);
    }
    let map = read(&folder.path().join("map.vtu")).unwrap();
    assert_eq!(map.mesh.tets.len(), 24 * 512);
    assert_eq!(answer["verdict"]["characteristic-map"]["tets"], 24 * 512);
    assert_eq!(answer["verdict"]["characteristic-map"]["injective"], true);
    let names: Vec<&str> = map.point_fields.iter().map(|field| field.name.as_str()).collect();
    assert_eq!(names, ["preimage", "layer"]);
}

#[test]
fn places_that_make_no_sense_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    block(folder.path());
    let wrong: [(&[&str], i32, &str); 8] = [
        (&["spectrum"], 2, "--vertex"),
        (&["spectrum", "--vertex", "octahedron", "--edge", "5"], 2, "cannot be used with"),
        (&["spectrum", "--vertex", "cube"], 2, "expected bipyramid:N"),
        (&["spectrum", "--vertex", "bipyramid:2"], 2, "rings of 3 or more"),
        (&["spectrum", "--edge", "2"], 2, "3..=64"),
        (&["spectrum", "--vertex", "block.vtu:125"], 1, "there is no vertex 125"),
        (&["spectrum", "--vertex", "none.vtu:1"], 1, "none.vtu"),
        (&["spectrum", "--edge", "8", "--map", "map.vtu"], 1, "there is no map"),
    ];
    for (arguments, expected, says) in wrong {
        let output = octruss(folder.path(), arguments);
        assert_eq!(code(&output), expected, "{arguments:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(says), "{arguments:?}: {}", stderr(&output));
    }
    assert!(!folder.path().join("map.vtu").exists());
}

#[test]
fn a_basis_function_is_written_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let middle = block(folder.path()).to_string();
    let basis = ["basis", "block.vtu", "--vertex", &middle, "--levels", "2", "basis.vtu"];
    let line = ["--line", "line.csv", "--direction", "0,0,-1", "--scheme", "interpolatory"];
    succeed(folder.path(), &[&basis[..], &line[..]].concat());
    let written = read(&folder.path().join("basis.vtu")).unwrap();
    assert_eq!(written.mesh.tets.len(), 384 * 64);
    let [field] = &written.point_fields[..] else { panic!("one field") };
    let Values::Float(values) = &field.values else { panic!("numbers") };
    assert_eq!(field.name, "basis");
    // Old vertices keep their values.
    assert!(values[..125].iter().enumerate().all(|(v, &x)| x == f64::from(u8::from(v == 62))));

    let text = std::fs::read_to_string(folder.path().join("line.csv")).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("distance,x,y,z,value"));
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect();
    let at_vertex = rows.iter().find(|row| row[0] == 0.0).unwrap();
    assert_eq!(at_vertex[1..4], [2.0, 2.0, 2.0]);
    assert!((at_vertex[4] - 1.0).abs() < 1e-12);
    // It is symmetric, and goes down the z axis from one side of the block to the other.
    assert!(rows.iter().all(|row| (row[3] - (2.0 - row[0])).abs() < 1e-12));
    for (row, mirrored) in rows.iter().zip(rows.iter().rev()) {
        assert!((row[4] - mirrored[4]).abs() < 1e-12);
    }
}

#[test]
fn a_basis_function_may_start_on_a_finer_level() {
    let folder = tempfile::tempdir().unwrap();
    let middle = block(folder.path()).to_string();
    let basis = ["basis", "block.vtu", "--vertex", &middle, "--levels", "1", "basis.vtu"];
    succeed(folder.path(), &[&basis[..], &["--at-level", "1"]].concat());
    let written = read(&folder.path().join("basis.vtu")).unwrap();
    let Values::Float(values) = &written.point_fields[0].values else { panic!("numbers") };
    assert_eq!(values.iter().sum::<f64>(), 1.0);
    let late = octruss(folder.path(), &[&basis[..], &["--at-level", "2"]].concat());
    assert_eq!((code(&late), stderr(&late).contains("there is no level 2")), (1, true));
}

#[test]
fn real_meshes_have_convergent_vertices() {
    let bracket = sample("bracket.msh");
    for vertex in [0, 50] {
        let place = format!("{}:{vertex}", bracket.display());
        let answer = spectrum(Path::new("."), &["--vertex", &place]);
        assert_eq!(answer["verdict"]["convergent"], true, "{answer}");
    }
}
