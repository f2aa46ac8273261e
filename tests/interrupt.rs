//! Ctrl-C on a real process.
#![cfg(unix)]

mod common;

use std::io::{BufRead, BufReader, Read};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, ChildStderr, Command, Stdio};
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;

use assert_cmd::cargo::cargo_bin;
use common::{report, repository, succeed};
use octruss::Recipe;
use octruss::observer::{Event, StagePlace};
use octruss_meshio::Values;

/// Cycles alone never get to such a tolerance; a while passes until rounding ends them.
const ENDLESS: [&str; 3] = [
    "stage.solve.method=cycle",
    "stage.solve.tolerance=1e-300",
    "stage.solve.max-iterations=1000000000",
];

const CUBE: &str = "configs/cube-poisson.toml";

fn start(folder: &Path, configs: &[&str], set: &[&str]) -> (Child, BufReader<ChildStderr>) {
    let mut command = Command::new(cargo_bin("octruss"));
    command.current_dir(folder).arg("run").args(configs.iter().map(|path| repository(path)));
    command.args(set.iter().flat_map(|value| ["--set", value]));
    let mut child =
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("octruss starts");
    let stderr = BufReader::new(child.stderr.take().unwrap());
    (child, stderr)
}

/// Reads up to a line that contains `text`.
fn wait_for(stderr: &mut impl BufRead, text: &str) {
    let mut seen = String::new();
    while !seen.lines().last().is_some_and(|line| line.contains(text)) {
        assert!(stderr.read_line(&mut seen).unwrap() > 0, "no {text} in {seen}");
    }
}

fn interrupt(child: &Child) {
    let pid = child.id().to_string();
    assert!(Command::new("kill").args(["-s", "INT", &pid]).status().unwrap().success());
}

#[test]
fn a_solve_stops_between_iterations_and_keeps_its_iterate() {
    let folder = tempfile::tempdir().unwrap();
    let set = [&ENDLESS[..], &["stage.subdivide.levels=3"]].concat();
    let (mut child, mut stderr) = start(folder.path(), &[CUBE, "configs/quickstart.toml"], &set);
    wait_for(&mut stderr, "assembly");
    interrupt(&child);
    let mut rest = String::new();
    stderr.read_to_string(&mut rest).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1), "{rest}");
    let out = folder.path().join("out/cube-poisson");
    let report = report(&out);
    let unfinished = &report["unfinished"];
    assert_eq!(
        (&unfinished["stage"], &unfinished["what"]),
        (&"solve".into(), &"linear prolongation".into())
    );
    let iterations = unfinished["iterations"].as_u64().unwrap();
    assert!(iterations >= 1);
    let history = unfinished["residual_history"].as_array().unwrap();
    assert_eq!(history.len() as u64, iterations + 1);
    let residual = unfinished["relative_residual"].as_f64().unwrap();
    assert!(residual < 1.0);
    let says = format!(
        "error: stage `solve`, linear prolongation: stopped on request after {iterations} \
         iterations at a relative residual of {residual:.3e}; the last residuals: "
    );
    assert!(rest.contains(&says) && rest.contains("unfinished.vtu"), "{rest}");
    let names: Vec<_> = report["stages"]
        .as_array()
        .unwrap()
        .iter()
        .map(|stage| stage["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["import", "check", "subdivide"]);
    assert!(!out.join("solution.vtu").exists());
    let mut said = String::new();
    child.stdout.take().unwrap().read_to_string(&mut said).unwrap();
    assert!(said.starts_with("cube-poisson: failed") && said.ends_with("quickstart: not run\n"));
    let kept = octruss_meshio::read(&out.join("unfinished.vtu")).unwrap();
    assert_eq!((kept.mesh.tets.len(), kept.point_fields[0].name.as_str()), (184_320, "solution"));
    let Values::Float(values) = &kept.point_fields[0].values else { panic!() };
    // The solution is between 0 and 0.0562 in the middle; one cycle is near it.
    let greatest = values.iter().copied().fold(0.0, f64::max);
    assert!((0.04..0.06).contains(&greatest), "{greatest}");

    // A run that ends leaves nothing of the one that was stopped.
    let config = repository(CUBE).display().to_string();
    succeed(
        folder.path(),
        &["run", &config, "--quiet", "--set", "stage.subdivide.levels=1", "--set", "expect={}"],
    );
    assert!(!out.join("unfinished.vtu").exists());
    assert!(common::report(&out)["unfinished"].is_null());
}

#[test]
fn a_second_signal_ends_the_process_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let (mut child, mut stderr) = start(folder.path(), &[CUBE], &["stage.subdivide.levels=5"]);
    wait_for(&mut stderr, "level 1 of 5");
    interrupt(&child);
    wait_for(&mut stderr, "again to end at once");
    interrupt(&child);
    let status = child.wait().unwrap();
    assert_eq!((status.code(), status.signal()), (Some(130), None));
    assert!(!folder.path().join("out").exists());
}

#[test]
fn a_run_stops_before_the_next_stage() {
    let folder = tempfile::tempdir().unwrap();
    let recipe = Recipe::load(&repository(CUBE), &[]).unwrap();
    let stop = AtomicBool::new(false);
    let observer = |stage: &StagePlace, event: &Event| {
        let label = stage.label.as_str();
        assert!(stage.number <= 2, "{label} began");
        stop.store(matches!((label, event), ("check", Event::StageDone { .. })), Relaxed);
    };
    let outcome = octruss::run(&recipe, folder.path(), &observer, &stop);
    assert_eq!(outcome.unwrap_err().to_string(), "stopped on request before stage `subdivide`");
    assert!(common::files(folder.path()).is_empty());
}
