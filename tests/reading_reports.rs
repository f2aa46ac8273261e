//! Reports can be read back: those of now, and those of the schema as it was first.

mod common;

use std::path::Path;
use std::sync::atomic::AtomicBool;

use common::repository;
use octruss::comparison::{self, Comparison};
use octruss::observer::{Event, StagePlace};
use octruss::report::{Done, SCHEMA};
use octruss::{Recipe, Report};

/// Runs a config with one level, into a folder.
fn small(config: &str, more: &[&str], folder: &Path) -> Report {
    let set = ["stage.subdivide.levels=1"].iter().chain(more).map(|set| set.to_string());
    let recipe = Recipe::load(&repository(config), &set.collect::<Vec<_>>()).unwrap();
    let nobody = |_: &StagePlace, _: &Event| {};
    octruss::run(&recipe, folder, &nobody, &AtomicBool::new(false)).unwrap()
}

#[test]
fn a_report_reads_back_as_it_was() {
    let met = "expect={ \"solve.linear.iterations\" = { min = 1 } }";
    for (config, more) in [
        ("configs/quickstart.toml", &[met, "stage.solve.account=true"][..]),
        ("configs/cube-poisson.toml", &["expect={}", "stage.solve.cycle=full"]),
        ("configs/bracket-elasticity.toml", &["expect={}"]),
        ("configs/blended-cylinder.toml", &["expect={}"]),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let written = small(config, more, folder.path());
        let read = Report::read(&folder.path().join("report.json")).unwrap();
        assert_eq!(read, written, "{config}");
        assert_eq!(read.schema, SCHEMA);
        let json = serde_json::to_value(&read.stages).unwrap();
        let kinds: Vec<_> =
            json.as_array().unwrap().iter().map(|stage| stage["kind"].as_str().unwrap()).collect();
        let names: Vec<_> = written.stages.iter().map(|stage| stage.name.as_str()).collect();
        assert_eq!(kinds, names, "each kind is there once");
    }
}

#[test]
fn a_comparison_reads_back_as_it_was() {
    let set = ["stage.subdivide.levels=1", "compare.repeats=1"].map(String::from);
    let config = repository("configs/prolongation-study-cube.toml");
    let recipe = Recipe::load(&config, &set).unwrap();
    let nobody = |_: &StagePlace, _: &Event| {};
    let written = comparison::compare(&recipe, &nobody, &AtomicBool::new(false)).unwrap();
    assert!(!written.rows.is_empty() && !written.carried.is_empty());
    let folder = tempfile::tempdir().unwrap();
    written.write(folder.path()).unwrap();
    let text = std::fs::read_to_string(folder.path().join("compare.json")).unwrap();
    assert_eq!(serde_json::from_str::<Comparison>(&text).unwrap(), written);
}

/// JSON has no word for what is no finite number.
#[test]
fn what_is_no_number_reads_back_as_such() {
    let folder = tempfile::tempdir().unwrap();
    let mut report = small("configs/cube-poisson.toml", &["expect={}"], folder.path());
    let solve = |report: &mut Report| {
        let done = report.stages.iter_mut().find_map(|stage| match &mut stage.done {
            Done::Solve(done) => Some(done),
            _ => None,
        });
        done.unwrap().solves.remove(0)
    };
    let mut diverged = solve(&mut report);
    (diverged.relative_residual, diverged.minimum) = (f64::INFINITY, f64::NAN);
    diverged.residual_history = vec![1.0, f64::NEG_INFINITY];
    let Some(Done::Solve(done)) = report.stages.iter_mut().map(|stage| &mut stage.done).nth(3)
    else {
        panic!("the fourth stage solves")
    };
    done.solves.insert(0, diverged);
    report.write(folder.path()).unwrap();
    let path = folder.path().join("report.json");
    assert!(std::fs::read_to_string(&path).unwrap().contains("\"minimum\": null"));
    let read = solve(&mut Report::read(&path).unwrap());
    assert!(read.relative_residual.is_nan() && read.minimum.is_nan());
    assert!(read.residual_history[0] == 1.0 && read.residual_history[1].is_nan());
}

/// A file of the first schema, kept as it was written.
#[test]
fn a_report_of_schema_1_stays_readable() {
    let report = Report::read(&repository("tests/data/report-schema-1.json")).unwrap();
    assert_eq!((report.schema, report.config.as_str()), (1, "cube-poisson"));
    let number = |name: &str| {
        let numbers = report.numbers();
        numbers.iter().find(|(known, _)| known == name).unwrap_or_else(|| panic!("{name}")).1
    };
    // 360 tets, and eight times as many after a level.
    assert_eq!(number("subdivide.levels.0.tets"), 360.0);
    assert_eq!(number("subdivide.tets"), 2880.0);
    assert_eq!(number("solve.linear.levels"), 2.0);
    assert!(number("solve.linear.relative_residual") <= 1e-8);
    assert!(report.expectations[0].met && report.unfinished.is_none());
}

#[test]
fn another_schema_and_what_is_no_report_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.json");
    let first = std::fs::read_to_string(repository("tests/data/report-schema-1.json")).unwrap();
    let next = first.replace("\"schema\": 1", "\"schema\": 999");
    for (text, says) in [
        (next.as_str(), "it has schema 999, but 1 is read here"),
        ("{ \"octruss\": \"0.1.0\" }", "it is no report, for it has no `schema`"),
        ("{ \"schema\": 1 }", "missing field `octruss`"),
        ("{", "EOF while parsing"),
    ] {
        std::fs::write(&path, text).unwrap();
        let error = Report::read(&path).unwrap_err().to_string();
        let start = format!("cannot read the report {}: ", path.display());
        assert!(error.starts_with(&start) && error.contains(says), "{error}");
    }
    let missing = Report::read(&folder.path().join("none.json")).unwrap_err().to_string();
    assert!(missing.contains("none.json: "), "{missing}");
}
