//! The commands as a user or a script meets them.

mod common;

use std::io::Read;
use std::process::{Command, Stdio};

use common::{code, integers, octruss, sample, stderr, stdout, succeed};
use octruss_mesh::shapes::kuhn_cube;
use octruss_meshio::{Dataset, Field, read, write};
use serde_json::{Value, json};

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn help_teaches_with_examples() {
    let here = std::path::Path::new(".");
    let help = succeed(here, &["--help"]);
    for text in ["run", "info", "convert", "refine", "octruss run configs/quickstart.toml"] {
        assert!(help.contains(text), "{text} in\n{help}");
    }
    for command in ["run", "info", "convert", "refine", "spectrum", "basis"] {
        let help = succeed(here, &[command, "--help"]);
        assert!(help.contains("Example") && help.contains("octruss "), "{help}");
    }
    let refine = succeed(here, &["refine", "--help"]);
    for option in
        ["--scheme", "--levels", "--crease-angle", "--group-borders", "--reorient", "--threads"]
    {
        assert!(refine.contains(option), "{option}");
    }
}

#[test]
fn wrong_usage_exits_with_2() {
    let here = std::path::Path::new(".");
    let wrong: [&[&str]; 7] = [
        &[],
        &["dance"],
        &["run"],
        &["info"],
        &["refine", "a.msh", "b.vtu", "--scheme", "cubic", "--levels", "1"],
        &["refine", "a.msh", "b.vtu", "--scheme", "linear", "--levels", "-1"],
        &["run", "c.toml", "--threads", "0"],
    ];
    for arguments in wrong {
        let output = octruss(here, arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(stdout(&output).is_empty() && !stderr(&output).is_empty());
    }
}

/// A cube of 2³ cells: 27 vertices, 48 tets; of its edges 3 · 2 · 3² along axes,
/// 3 · 3 · 2² diagonals of squares and 2³ of cells, together 98.
#[test]
fn info_counts_and_measures_a_known_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = kuhn_cube(2).into_raw();
    write(&folder.path().join("cube.vtu"), &Dataset { mesh, ..Dataset::default() }).unwrap();
    let info = json(&succeed(folder.path(), &["info", "cube.vtu", "--json"]));
    assert_eq!(info["vertices"], 27);
    assert_eq!(info["tets"], 48);
    assert_eq!(info["edges"], 98);
    assert_eq!(info["boundary_faces"], 48);
    assert_eq!(info["components"], 1);
    assert!((info["volume"].as_f64().unwrap() - 1.0).abs() < 1e-14);
    assert_eq!(info["findings"], json!([]));
    assert_eq!(info["regions"], json!([]));
    let names = ["x0", "x1", "y0", "y1", "z0", "z1"];
    for (index, name) in names.into_iter().enumerate() {
        let expected = json!({ "name": name, "id": index + 1, "count": 8, "area": 1.0 });
        assert_eq!(info["surfaces"][index], expected);
    }
    // Every Kuhn tet: V = h³/6, edges h (3), h√2 (2), h√3 (1):
    // η = 12 (1/2)^(2/3) / 10; dihedral angles 45°, 60° and 90°.
    let quality = &info["quality"];
    let eta = 12.0 * 0.25f64.cbrt() / 10.0;
    for (key, value) in [
        ("eta_min", eta),
        ("eta_mean", eta),
        ("dihedral_min_deg", 45.0),
        ("dihedral_max_deg", 90.0),
    ] {
        assert!((quality[key].as_f64().unwrap() - value).abs() < 1e-9, "{key}: {quality}");
    }
}

#[test]
fn info_names_regions_and_draws_a_histogram() {
    let here = std::path::Path::new(".");
    let bracket = sample("bracket.msh").display().to_string();
    let info = json(&succeed(here, &["info", &bracket, "--json"]));
    // The counts that the .geo file states.
    assert_eq!((&info["vertices"], &info["tets"]), (&json!(1117), &json!(3098)));
    let groups = |key: &str| -> Vec<(String, u64)> {
        let group = |g: &Value| (g["name"].as_str().unwrap().into(), g["count"].as_u64().unwrap());
        info[key].as_array().unwrap().iter().map(group).collect()
    };
    let expected = |list: &[(&str, u64)]| -> Vec<(String, u64)> {
        list.iter().map(|&(name, count)| (name.into(), count)).collect()
    };
    assert_eq!(groups("regions"), expected(&[("plate", 2557), ("ribs", 541)]));
    assert_eq!(
        groups("surfaces"),
        expected(&[("bolts", 192), ("base", 784), ("load", 42), ("free", 1138)])
    );
    // The top of the ribs: two bars of 28 × 9 that cross in a square of 9 × 9.
    let load = info["surfaces"][2]["area"].as_f64().unwrap();
    assert!((load - (2.0 * 28.0 * 9.0 - 81.0)).abs() < 1e-9, "{load}");
    let card = succeed(here, &["info", &bracket]);
    for text in ["3098", "plate", "bolts", "mean ratio η", "█"] {
        assert!(card.contains(text), "{text} in\n{card}");
    }
}

#[test]
fn refining_by_two_levels_equals_twice_by_one() {
    let folder = tempfile::tempdir().unwrap();
    let bracket = sample("bracket.msh").display().to_string();
    for scheme in ["linear", "box-spline"] {
        let refine = |input: &str, output: &str, levels: &str| {
            let arguments = ["refine", input, output, "--scheme", scheme, "--levels", levels];
            succeed(folder.path(), &arguments);
            std::fs::read(folder.path().join(output)).unwrap()
        };
        refine(&bracket, "once.vtu", "1");
        assert!(refine("once.vtu", "twice.vtu", "1") == refine(&bracket, "both.vtu", "2"));
        let info = json(&succeed(folder.path(), &["info", "both.vtu", "--json"]));
        assert_eq!(info["tets"], 64 * 3098);
        assert_eq!(info["surfaces"][0]["name"], "bolts");
        assert_eq!(info["surfaces"][0]["count"], 16 * 192);
    }
}

#[test]
fn the_crease_angle_decides_what_stays_sharp() {
    let folder = tempfile::tempdir().unwrap();
    let mut mesh = kuhn_cube(2).into_raw();
    // Without groups only the angle of 90 degrees can keep the cube's edges.
    mesh.triangles = Default::default();
    mesh.groups.clear();
    write(&folder.path().join("cube.vtu"), &Dataset { mesh, ..Dataset::default() }).unwrap();
    let volume = |more: &[&str]| {
        let arguments =
            ["refine", "cube.vtu", "out.vtu", "--scheme", "box-spline", "--levels", "1"];
        // Else the smooth surface would go round the cube.
        let published = ["--interpolate=false"];
        succeed(folder.path(), &[&arguments[..], &published, more].concat());
        json(&succeed(folder.path(), &["info", "out.vtu", "--json"]))["volume"].as_f64().unwrap()
    };
    assert!((volume(&[]) - 1.0).abs() < 1e-12);
    assert!((volume(&["--crease-angle", "80"]) - 1.0).abs() < 1e-12);
    assert!(volume(&["--crease-angle", "180"]) < 0.9);
}

#[test]
fn borders_between_groups_stay_sharp_as_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = kuhn_cube(2).into_raw();
    write(&folder.path().join("cube.vtu"), &Dataset { mesh, ..Dataset::default() }).unwrap();
    let volume = |more: &[&str]| {
        let arguments = "refine cube.vtu out.vtu --scheme box-spline --levels 1 --crease-angle 180 \
                         --interpolate=false";
        let arguments: Vec<&str> = arguments.split(' ').chain(more.iter().copied()).collect();
        succeed(folder.path(), &arguments);
        json(&succeed(folder.path(), &["info", "out.vtu", "--json"]))["volume"].as_f64().unwrap()
    };
    for kept in ["all", "true"] {
        assert!((volume(&["--group-borders", kept]) - 1.0).abs() < 1e-12);
    }
    // At right angles they are not flat.
    let round = volume(&[]);
    assert!(round < 0.9);
    for rounded in ["flat", "none", "false"] {
        assert_eq!(volume(&["--group-borders", rounded]), round);
    }
}

#[test]
fn fields_ride_along_and_stay_what_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = kuhn_cube(1).into_raw();
    let heights = mesh.points.iter().map(|point| 1.0 + 2.0 * point[2]).collect();
    let input = Dataset {
        point_fields: vec![Field::scalar("height", heights)],
        cell_fields: vec![Field::scalar("number", (0..6).map(f64::from).collect())],
        mesh,
        ..Dataset::default()
    };
    write(&folder.path().join("in.vtu"), &input).unwrap();
    succeed(
        folder.path(),
        &["refine", "in.vtu", "out.vtu", "--scheme", "box-spline", "--levels", "2"],
    );
    let output = read(&folder.path().join("out.vtu")).unwrap();
    // The matrix that moves points carries the field: a linear one stays linear.
    let expected: Vec<f64> = output.mesh.points.iter().map(|point| 1.0 + 2.0 * point[2]).collect();
    let octruss_meshio::Values::Float(heights) = &output.point_fields[0].values else { panic!() };
    assert_eq!(heights.len(), expected.len());
    assert!(heights.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-13));
    let octruss_meshio::Values::Float(numbers) = &output.cell_fields[0].values else { panic!() };
    let tets = integers(&output.cell_fields, "input-tet");
    assert_eq!(numbers.len(), 6 * 64);
    assert!(numbers.iter().zip(tets).all(|(&number, &tet)| number == tet as f64));
}

#[test]
fn convert_keeps_everything_in_a_vtu() {
    let folder = tempfile::tempdir().unwrap();
    let bracket = sample("bracket.msh");
    let path = bracket.display().to_string();
    succeed(folder.path(), &["convert", &path, "bracket.vtu"]);
    succeed(folder.path(), &["convert", "bracket.vtu", "again.vtu"]);
    let original = read(&bracket).unwrap();
    let converted = read(&folder.path().join("bracket.vtu")).unwrap();
    assert!(converted.mesh == original.mesh);
    let bytes = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    assert!(bytes("bracket.vtu") == bytes("again.vtu"));
    // A legacy file has no room for names, which is said.
    let output = octruss(folder.path(), &["convert", "bracket.vtu", "bracket.vtk"]);
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).starts_with("note: "), "{}", stderr(&output));
    let legacy = read(&folder.path().join("bracket.vtk")).unwrap();
    assert!(legacy.mesh.tets == original.mesh.tets && legacy.mesh.points == original.mesh.points);
}

#[test]
fn progress_is_plain_lines_on_stderr_or_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let cube = sample("cube.msh").display().to_string();
    let arguments = ["refine", &cube, "out.vtu", "--scheme", "linear", "--levels", "2"];
    let output = octruss(folder.path(), &arguments);
    assert!(stdout(&output).is_empty());
    let lines = stderr(&output);
    assert!(lines.contains("[3/3] subdivide: level 2 of 2 … 23.0 k tets, "), "{lines}");
    assert!(!lines.contains('\u{1b}'), "no control characters");
    let output = octruss(folder.path(), &[&arguments[..], &["--quiet"]].concat());
    assert!(stderr(&output).is_empty() && code(&output) == 0);
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_octruss"))
        .args(["info".as_ref(), sample("bracket.msh").as_os_str()])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let mut message = String::new();
    child.stderr.take().unwrap().read_to_string(&mut message).unwrap();
    assert!(child.wait().unwrap().success());
    assert_eq!(message, "");
}

#[test]
fn options_that_come_too_late_are_told_even_when_quiet() {
    let folder = tempfile::tempdir().unwrap();
    let cube = sample("cube.msh").display().to_string();
    let refine = |input: &str, more: &[&str]| {
        let arguments =
            ["refine", input, "out.vtu", "--scheme", "linear", "--levels", "1", "--quiet"];
        let output = octruss(folder.path(), &[&arguments[..], more].concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        stderr(&output)
    };
    assert_eq!(refine(&cube, &["--crease-angle", "30"]), "");
    assert!(folder.path().join("out.surfaces.vtu").exists());
    assert_eq!(refine("out.vtu", &[]), "");
    let note = refine("out.vtu", &["--crease-angle", "30", "--marking", "agree"]);
    assert!(note.starts_with("note: ") && note.contains("marking, crease-angle"), "{note}");
}
