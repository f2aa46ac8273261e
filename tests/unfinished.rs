//! A solve that does not reach its goal leaves its best iterate.

mod common;

use common::{code, files, octruss, report, repository, stderr, succeed};
use octruss_meshio::Values;

#[test]
fn a_solve_out_of_iterations_keeps_its_best_iterate() {
    let folder = tempfile::tempdir().unwrap();
    let config = repository("configs/cube-poisson.toml").display().to_string();
    let levels = ["--set", "stage.subdivide.levels=1", "--set", "expect={}"];
    let run = [&["run", &config, "--quiet"], &levels[..]].concat();
    let few = [&run[..], &["--set", "stage.solve.max-iterations=2"]].concat();
    let output = octruss(folder.path(), &few);
    let message = stderr(&output);
    assert_eq!(code(&output), 1, "{message}");
    let out = folder.path().join("out/cube-poisson");
    let whole = report(&out);
    let unfinished = &whole["unfinished"];
    let residual = unfinished["relative_residual"].as_f64().unwrap();
    let reason = format!("no convergence: relative residual {residual:.3e} after 2 iterations");
    assert_eq!(unfinished["reason"], reason.as_str());
    let says =
        format!("error: stage `solve`, linear prolongation: {reason}; the last residuals: 1.0e0, ");
    assert!(message.starts_with(&says), "{message}");
    assert!(message.contains("; the iterate with the smallest is in "), "{message}");
    let history = unfinished["residual_history"].as_array().unwrap();
    let smallest = history.iter().map(|r| r.as_f64().unwrap()).fold(f64::INFINITY, f64::min);
    assert!((residual / smallest - 1.0).abs() < 1e-6 && history.len() == 3);
    assert_eq!(whole["stages"].as_array().unwrap().len(), 3);

    // Two iterations are near the solution, which is 0.0562 in the middle.
    let kept = octruss_meshio::read(&out.join("unfinished.vtu")).unwrap();
    assert_eq!((kept.mesh.tets.len(), kept.point_fields[0].name.as_str()), (2880, "solution"));
    let Values::Float(values) = &kept.point_fields[0].values else { panic!() };
    let greatest = values.iter().copied().fold(0.0, f64::max);
    assert!((0.04..0.06).contains(&greatest), "{greatest}");
    assert_eq!(files(&out).len(), 2);

    succeed(folder.path(), &run);
    assert!(!out.join("unfinished.vtu").exists() && report(&out)["unfinished"].is_null());
}
