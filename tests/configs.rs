//! Every config runs when made small; `full_size` runs them as they are.

mod common;

use common::{code, configs, octruss, report, repository, stderr, succeed};
use serde_json::Value;

fn strings(path: &std::path::Path, more: &[&str]) -> Vec<String> {
    let path = path.display().to_string();
    ["run", &path].iter().chain(more).map(|text| text.to_string()).collect()
}

#[test]
fn every_config_runs_when_made_small() {
    let configs = configs();
    assert!(configs.len() >= 2);
    for config in configs {
        let folder = tempfile::tempdir().unwrap();
        let small = ["--out", "small", "--set", "stage.subdivide.levels=1", "--set", "expect={}"];
        succeed(folder.path(), &strings(&config, &small));
        let report = report(&folder.path().join("small"));
        let stages = report["stages"].as_array().unwrap();
        let subdivide = stages.iter().find(|stage| stage["name"] == "subdivide").unwrap();
        let levels = subdivide["levels"].as_array().unwrap();
        assert_eq!(levels.len(), 2, "{}", config.display());
    }
}

#[test]
fn the_quickstart_writes_what_its_comments_promise() {
    let folder = tempfile::tempdir().unwrap();
    let config = repository("configs/quickstart.toml");
    let small = ["--set", "stage.subdivide.levels=1", "--set", "expect={}"];
    let printed = succeed(folder.path(), &strings(&config, &small));
    for row in ["iterations", "mean reduction", "nonzeros", "work per digit", "seconds"] {
        assert!(printed.contains(row), "{row} in\n{printed}");
    }
    let out = folder.path().join("out/quickstart");
    let solution = octruss_meshio::read(&out.join("solution.vtu")).unwrap();
    assert_eq!(solution.mesh.tets.len(), 8 * 3098);
    assert_eq!(solution.mesh.group_names(3), ["plate", "ribs"]);
    assert_eq!(solution.mesh.group_names(2), ["bolts", "base", "load", "free"]);
    let names = |fields: &[octruss_meshio::Field]| -> Vec<String> {
        fields.iter().map(|field| field.name.clone()).collect()
    };
    assert_eq!(names(&solution.point_fields), ["solution", "stratum", "input-vertex"]);
    assert_eq!(names(&solution.cell_fields), ["quality", "input-tet"]);
    let surfaces = std::fs::read(out.join("solution.surfaces.vtu")).unwrap();
    assert!(surfaces.starts_with(b"<?xml") || surfaces.starts_with(b"<VTKFile"));
    let coarse = octruss_meshio::read(&out.join("level-0.vtu")).unwrap();
    assert_eq!((coarse.mesh.points.len(), coarse.mesh.tets.len()), (1117, 3098));
    let list = std::fs::read_to_string(out.join("levels.pvd")).unwrap();
    assert!(list.contains("level-0.vtu") && list.contains("level-1.vtu"), "{list}");
    assert!(!list.contains("level-2.vtu"));
}

#[test]
fn several_configs_run_in_turn_and_share_the_folder_given() {
    let folder = tempfile::tempdir().unwrap();
    let cube = repository("configs/cube-poisson.toml");
    let bracket = repository("configs/quickstart.toml").display().to_string();
    let more = [
        bracket.as_str(),
        "--out",
        "both",
        "--set",
        "stage.subdivide.levels=1",
        "--set",
        "expect={ \"subdivide.tets\" = { max = 3000 } }",
    ];
    // The cube has 2,880 tets after one level, the bracket more.
    let output = octruss(folder.path(), &strings(&cube, &more));
    assert_eq!(code(&output), 1, "{}", stderr(&output));
    let printed = common::stdout(&output);
    assert!(printed.contains("cube-poisson: good") && printed.contains("quickstart: failed"));
    assert!(stderr(&output).contains("`subdivide.tets` is 24784, expected at most 3000"));
    for name in ["cube-poisson", "quickstart"] {
        let report = report(&folder.path().join("both").join(name));
        assert_eq!(report["config"], Value::from(name));
    }
}
