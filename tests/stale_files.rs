//! A run leaves no files of an earlier one that could be taken for its own.

mod common;

use std::path::Path;

use common::{files, report, repository, succeed};

/// The names of what a folder holds, sorted.
fn names(folder: &Path) -> Vec<String> {
    let name = |path: String| Path::new(&path).file_name().unwrap().to_str().unwrap().to_owned();
    files(folder).into_iter().map(name).collect()
}

#[test]
fn files_of_an_earlier_run_with_more_levels_are_removed_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let config = repository("configs/cube-poisson.toml").display().to_string();
    let run = |levels: &str, more: &[&str]| {
        let levels = format!("stage.subdivide.levels={levels}");
        let run = ["run", &config, "--quiet", "--set", "expect={}", "--set", &levels];
        let sets = more.iter().flat_map(|set| ["--set", *set]);
        succeed(folder.path(), &run.into_iter().chain(sets).collect::<Vec<_>>());
    };
    let out = folder.path().join("out/cube-poisson");
    run("2", &["stage.write.levels=true"]);
    let written = names(&out);
    assert!(written.contains(&"level-2.vtu".into()), "{written:?}");
    // Names that are like those of the stage, but none of them.
    let others = ["level-02.vtu", "level-x.vtu", "level-2.vtk", "levels-2.vtu", "my.surfaces.vtu"];
    for other in others {
        std::fs::write(out.join(other), "mine").unwrap();
    }
    std::fs::write(out.join("solution.sides.vtu"), "of a run with fields that jump").unwrap();
    std::fs::create_dir(out.join("level-7.vtu")).unwrap();

    run("1", &["stage.write.levels=true"]);
    let mut expected: Vec<String> = written.into_iter().filter(|n| n != "level-2.vtu").collect();
    expected.extend(others.map(String::from));
    expected.sort();
    assert_eq!(names(&out), expected);
    assert!(out.join("level-7.vtu").is_dir());
    let removed = report(&out)["stages"][4]["removed"].as_array().unwrap().clone();
    let removed: Vec<&str> = removed.iter().map(|path| path.as_str().unwrap()).collect();
    assert_eq!(removed.len(), 2);
    assert!(removed[0].ends_with("level-2.vtu") && removed[1].ends_with("solution.sides.vtu"));

    let less = ["levels", "surfaces", "features"].map(|key| format!("stage.write.{key}=false"));
    run("1", &less.each_ref().map(String::as_str));
    let mut expected: Vec<String> = others.map(String::from).into();
    expected.extend(["report.json", "solution.vtu"].map(String::from));
    expected.sort();
    assert_eq!(names(&out), expected);
}

#[test]
fn what_an_earlier_stage_of_the_same_run_wrote_stays() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = octruss_mesh::shapes::kuhn_cube(1).into_raw();
    let dataset = octruss_meshio::Dataset { mesh, ..Default::default() };
    octruss_meshio::write(&folder.path().join("cube.vtu"), &dataset).unwrap();
    let stage = |kind: &str, options: &str| format!("[[stage]]\nkind = \"{kind}\"\n{options}\n");
    let config = [
        "name = \"c\"\n".into(),
        stage("import", "path = \"cube.vtu\""),
        stage("check", ""),
        stage("subdivide", "levels = 1\nscheme = \"linear\""),
        stage("write", ""),
        stage("write", "levels = false\nfeatures = false"),
    ];
    std::fs::write(folder.path().join("c.toml"), config.concat()).unwrap();
    succeed(folder.path(), &["run", "c.toml", "--quiet"]);
    let written = names(&folder.path().join("out/c"));
    for name in ["features.vtu", "level-0.vtu", "level-1.vtu", "levels.pvd"] {
        assert!(written.contains(&name.into()), "{written:?}");
    }
}

#[test]
fn the_mesh_that_a_run_reads_stays_whatever_it_is_called() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = octruss_mesh::shapes::kuhn_cube(1).into_raw();
    let dataset = octruss_meshio::Dataset { mesh, ..Default::default() };
    let input = folder.path().join("level-3.vtu");
    octruss_meshio::write(&input, &dataset).unwrap();
    std::fs::write(folder.path().join("level-2.vtu"), "of an earlier run").unwrap();
    let config = "name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"level-3.vtu\"\n\
                  [[stage]]\nkind = \"check\"\n[[stage]]\nkind = \"write\"\n";
    std::fs::write(folder.path().join("c.toml"), config).unwrap();
    succeed(folder.path(), &["run", "c.toml", "--quiet", "--out", "."]);
    let left = names(folder.path());
    assert!(left.contains(&"level-3.vtu".into()) && !left.contains(&"level-2.vtu".into()));
}
