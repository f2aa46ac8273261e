//! What the tests of the command share.
#![allow(dead_code, reason = "each test program uses its own part")]

use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use octruss_meshio::{Field, Values};

/// A path inside the repository.
pub fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// A sample mesh.
pub fn sample(name: &str) -> PathBuf {
    repository("examples/meshes").join(name)
}

/// All configs, sorted.
pub fn configs() -> Vec<PathBuf> {
    let mut configs: Vec<PathBuf> = std::fs::read_dir(repository("configs"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    configs.sort();
    configs
}

/// Runs `octruss` in a folder.
pub fn octruss<S: AsRef<std::ffi::OsStr>>(folder: &Path, arguments: &[S]) -> Output {
    Command::cargo_bin("octruss").unwrap().current_dir(folder).args(arguments).output().unwrap()
}

/// What a command printed on stdout.
pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// What a command printed on stderr.
pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// The exit code of a command that ended by itself.
pub fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

/// Runs `octruss`, which must succeed; gives back what it printed on stdout.
pub fn succeed<S: AsRef<std::ffi::OsStr>>(folder: &Path, arguments: &[S]) -> String {
    let output = octruss(folder, arguments);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    stdout(&output)
}

/// The `report.json` in a folder.
pub fn report(folder: &Path) -> serde_json::Value {
    let text = std::fs::read_to_string(folder.join("report.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// The values of a field of whole numbers.
pub fn integers<'a>(fields: &'a [Field], name: &str) -> &'a [i64] {
    let field = fields.iter().find(|field| field.name == name).unwrap();
    let Values::Integer(numbers) = &field.values else { panic!("{name} is whole") };
    numbers
}

/// The names of all files below a folder, sorted.
pub fn files(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                names.push(path.display().to_string());
            }
        }
    }
    names.sort();
    names
}
