//! The names in `report.json` are a promise.

mod common;

use common::{code, octruss, report, repository, stderr, succeed};

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
    assert_eq!(names, ["solution", "solution-2"]);
    let octruss_meshio::Values::Float(values) = &solution.point_fields[1].values else { panic!() };
    for (point, value) in solution.mesh.points.iter().zip(values) {
        let exact = 1.0 + 2.0 * (point[0] - 0.5 * point[0] * point[0]);
        assert!((value - exact).abs() < 0.01, "{value} instead of {exact}");
    }
}
