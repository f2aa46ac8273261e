//! The names in `report.json` are a promise.

mod common;

use common::{code, integers, octruss, report, repository, stderr, succeed};

fn small(name: &str, more: &[&str]) -> Vec<String> {
    let config = repository("configs").join(name).display().to_string();
    let start = ["run", &config, "--out", "out", "--set", "stage.subdivide.levels=1"];
    start.iter().chain(more).map(|text| text.to_string()).collect()
}

#[test]
fn every_promised_key_is_there_and_sensible() {
    let folder = tempfile::tempdir().unwrap();
    succeed(folder.path(), &small("quickstart.toml", &["--set", "expect={}"]));
    let report = report(&folder.path().join("out"));
    assert_eq!(report["octruss"], env!("CARGO_PKG_VERSION"));
    assert_eq!(report["config"], "quickstart");
    let stages = report["stages"].as_array().unwrap();
    let names: Vec<_> = stages.iter().map(|stage| stage["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["import", "check", "subdivide", "solve", "write"]);
    assert!(stages.iter().all(|stage| stage["seconds"].as_f64().unwrap() > 0.0));
    let peak = &report["peak_memory_bytes"];
    if cfg!(target_os = "linux") {
        assert!(peak.as_u64().unwrap() > 1 << 20);
    } else {
        assert!(peak.is_null());
    }
    let solves = stages[3]["solves"].as_array().unwrap();
    assert_eq!(solves.len(), 2);
    for (solve, prolongation) in solves.iter().zip(["box-spline", "linear"]) {
        assert_eq!(solve["prolongation"], prolongation);
        assert_eq!(solve["levels"], 2);
        let iterations = solve["iterations"].as_u64().unwrap() as usize;
        let history = solve["residual_history"].as_array().unwrap();
        assert_eq!(history.len(), iterations + 1);
        assert_eq!(history[0], 1.0);
        assert!(solve["relative_residual"].as_f64().unwrap() <= 1e-8);
        let complexity = solve["operator_complexity"].as_f64().unwrap();
        assert!((1.0..2.5).contains(&complexity), "{complexity}");
        assert!(solve["unknowns"].as_u64().unwrap() > 1117);
        for key in ["setup_seconds", "solve_seconds", "work_per_digit", "mean_reduction"] {
            assert!(solve[key].as_f64().unwrap() > 0.0, "{key}");
        }
        assert_eq!(solve["affine_defects"].as_array().unwrap().len(), 1);
    }
    // Positions are the box-spline matrix times coarse positions, so it misses
    // nothing; midpoints miss the smoothed positions by far.
    assert!(solves[0]["affine_defects"][0].as_f64().unwrap() < 1e-12);
    assert!(solves[1]["affine_defects"][0].as_f64().unwrap() > 1e-2);
}

#[test]
fn a_missed_expectation_fails_the_run_and_keeps_its_output() {
    let folder = tempfile::tempdir().unwrap();
    let expect = "expect={ \"solve.linear.iterations\" = { max = 2 } }";
    let output = octruss(folder.path(), &small("cube-poisson.toml", &["--set", expect]));
    assert_eq!(code(&output), 1);
    let message = stderr(&output);
    assert!(message.contains("`solve.linear.iterations` is "), "{message}");
    assert!(message.contains("expected at most 2"), "{message}");
    let report = report(&folder.path().join("out"));
    assert_eq!(report["expectations"][0]["met"], false);
    assert_eq!(report["expectations"][0]["max"], 2.0);
    assert!(folder.path().join("out/solution.vtu").exists());
}

#[test]
fn an_expectation_of_nothing_is_refused_with_the_names_there_are() {
    let folder = tempfile::tempdir().unwrap();
    let expect = "expect={ \"solve.linear.iteratons\" = { max = 9 } }";
    let output = octruss(folder.path(), &small("cube-poisson.toml", &["--set", expect]));
    assert_eq!(code(&output), 2);
    let message = stderr(&output);
    assert!(message.contains("the report has no number `solve.linear.iteratons`"), "{message}");
    assert!(message.contains("did you mean `solve.linear.iterations`?"), "{message}");
    assert!(message.contains("solve.linear.operator_complexity"), "{message}");
}

#[test]
fn the_results_are_the_same_for_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let mut results = Vec::new();
    for threads in ["1", "2", "3"] {
        let more = ["--set", "expect={}", "--threads", threads];
        succeed(folder.path(), &small("quickstart.toml", &more));
        let report = report(&folder.path().join("out"));
        assert_eq!(report["threads"].to_string(), threads);
        let history = report["stages"][3]["solves"][0]["residual_history"].clone();
        results.push((std::fs::read(folder.path().join("out/solution.vtu")).unwrap(), history));
    }
    assert!(results[0] == results[1] && results[1] == results[2]);
}

#[test]
fn the_second_solve_of_a_run_goes_by_its_own_name() {
    let folder = tempfile::tempdir().unwrap();
    let config = std::fs::read_to_string(repository("configs/cube-poisson.toml")).unwrap();
    let second = "[[stage]]\nkind = \"solve\"\nsource = { cube = 2.0 }\nprolongation = \
        [\"linear\"]\nfixed = [{ surface = \"x0\", value = 1.0 }]\n\n[[stage]]\nkind = \"write\"";
    let mesh = common::sample("cube.msh").display().to_string();
    let config = config
        .replace("../examples/meshes/cube.msh", &mesh)
        .replace("[[stage]]\nkind = \"write\"", second);
    std::fs::write(folder.path().join("two.toml"), config).unwrap();
    // u = 1 + 2 (x − x²/2) solves −u'' = 2 with u(0) = 1, u'(1) = 0: u(1) = 2.
    let arguments = [
        "run",
        "two.toml",
        "--set",
        "stage.subdivide.levels=2",
        "--set",
        "stage.solve-2.tolerance=1e-10",
        "--set",
        "expect={ \"solve-2.linear.maximum\" = { min = 1.99, max = 2.01 } }",
    ];
    succeed(folder.path(), &arguments);
    let out = folder.path().join("out/cube-poisson");
    assert_eq!(report(&out)["stages"][4]["name"], "solve-2");
    let solution = octruss_meshio::read(&out.join("solution.vtu")).unwrap();
    let names: Vec<_> = solution.point_fields.iter().map(|field| field.name.as_str()).collect();
    assert_eq!(names, ["solution", "solution-2", "stratum", "input-vertex"]);
    let octruss_meshio::Values::Float(values) = &solution.point_fields[1].values else { panic!() };
    for (point, value) in solution.mesh.points.iter().zip(values) {
        let exact = 1.0 + 2.0 * (point[0] - 0.5 * point[0] * point[0]);
        assert!((value - exact).abs() < 0.01, "{value} instead of {exact}");
    }
}

/// A free-standing tagged triangle far below the cube: nothing is solved there.
#[test]
fn vertices_outside_all_tets_hold_no_solution_and_do_not_count() {
    let folder = tempfile::tempdir().unwrap();
    let mut mesh = octruss_mesh::shapes::kuhn_cube(2).into_raw();
    let first = mesh.points.len() as u32;
    mesh.points.extend([[0.0, 0.0, -9.0], [1.0, 0.0, -9.0], [0.0, 1.0, -9.0]]);
    mesh.triangles.push([first, first + 1, first + 2], 9);
    let dataset = octruss_meshio::Dataset { mesh, ..Default::default() };
    octruss_meshio::write(&folder.path().join("cube.vtu"), &dataset).unwrap();
    let config = "name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"cube.vtu\"\n[[stage]]\n\
        kind = \"check\"\n[[stage]]\nkind = \"solve\"\nsource = 1\nprolongation = [\"linear\"]\n\
        fixed = [{ surface = \"x0\", value = 5 }]\n[[stage]]\nkind = \"write\"\n";
    std::fs::write(folder.path().join("c.toml"), config).unwrap();
    succeed(folder.path(), &["run", "c.toml"]);
    let out = folder.path().join("out/c");
    let solve = &report(&out)["stages"][2]["solves"][0];
    // u = 5 + x − x²/2 is 5 at x = 0 and at least that elsewhere.
    assert_eq!(solve["minimum"], 5.0);
    let solution = octruss_meshio::read(&out.join("solution.vtu")).unwrap();
    let octruss_meshio::Values::Float(values) = &solution.point_fields[0].values else { panic!() };
    let numbers = integers(&solution.point_fields, "input-vertex");
    let blank = numbers.iter().zip(values).filter(|(_, value)| value.is_nan());
    let mut blank: Vec<i64> = blank.map(|(&number, _)| number).collect();
    blank.sort_unstable();
    assert_eq!(blank, [27, 28, 29]);
}

#[test]
fn the_report_tells_the_marking_the_sharp_parts_and_the_guard() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = octruss_mesh::shapes::kuhn_cube(2).into_raw();
    let dataset = octruss_meshio::Dataset { mesh, ..Default::default() };
    octruss_meshio::write(&folder.path().join("cube.vtu"), &dataset).unwrap();
    let config = "name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"cube.vtu\"\n[[stage]]\n\
        kind = \"check\"\n[[stage]]\nkind = \"subdivide\"\nscheme = \"loop-solid\"\n\
        interior = 0.75\nmarking = \"agree\"\nmin-quality = 0.2\nextra-corners = [0]\n\
        extra-creases = [[0, 13]]\n";
    std::fs::write(folder.path().join("c.toml"), config).unwrap();
    let set = |value: &str| octruss(folder.path(), &["run", "c.toml", "--quiet", "--set", value]);
    let output = set("expect={}");
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let report = report(&folder.path().join("out/c"));
    let subdivide = &report["stages"][2];
    assert_eq!(
        (&subdivide["scheme"], &subdivide["interior"]),
        (&"loop-solid".into(), &0.75.into())
    );
    // Twelve edges of the cube, two mesh edges each, and the diagonal asked for;
    // six sides of four squares with two triangles each; 48 · 4 = 2 · interior + 48.
    assert_eq!(subdivide["strata"]["crease_edges"], 12 * 2 + 1);
    assert_eq!(subdivide["strata"]["surface_faces"], 48);
    assert_eq!(subdivide["strata"]["corners"], 1);
    assert_eq!(subdivide["marking"]["interior_faces"], 72);
    // The Kuhn lattice has a two-colouring, and so a marking without conflicts.
    assert_eq!(subdivide["marking"]["conflicting_faces"], 0);
    assert!(subdivide["marking"]["edge_valences"]["5"].is_null());
    assert_eq!(subdivide["levels"][1]["guard"]["floor"], 0.2);
    for (value, says, expected) in [
        ("stage.subdivide.scheme=linear", "`interior` belongs to `loop-solid`, but", 2),
        ("stage.subdivide.tension=0.1", "`tension` belongs to `interpolatory`", 2),
        ("stage.subdivide.min-quality=2", "expected a number from 0 to 1, found 2", 2),
        ("stage.subdivide.marking=agre", "unknown marking `agre`; did you mean `agree`?", 2),
        ("stage.subdivide.diagonal=long", "unknown diagonal `long` (valid: inherit, ", 2),
        ("stage.subdivide.extra-corners=[27]", "the corner 27 is no vertex of the mesh", 1),
        ("stage.subdivide.extra-creases=[[0, 26]]", "the crease 0-26 is no edge", 1),
        ("stage.subdivide.extra-creases=[[0, 1, 2]]", "the two ends of an edge, found 3", 2),
        ("expect={\"subdivide.tets\"=3}", "expected bounds such as { min = 1, max = 2 }", 2),
    ] {
        let output = set(value);
        assert!(stderr(&output).contains(says), "{value}: {}", stderr(&output));
        assert_eq!(code(&output), expected, "{value}");
    }
}
