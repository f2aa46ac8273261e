//! The code of a crate's modules, and the paths that it names.

use std::collections::BTreeMap;
use std::path::Path;

/// The code of each module by its path, such as `recipe::parse`; that of the crate's own
/// is empty.
pub type Modules = BTreeMap<String, String>;

/// So many files side by side are still found by eye.
const MOST_FILES: usize = 16;

/// Adds the modules below a folder of this path, but for `main`, which is the command.
pub fn read(folder: &Path, path: &str, modules: &mut Modules) {
    let mut files = 0;
    for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let name = entry.file_stem().unwrap().to_str().unwrap();
        if entry.is_dir() {
            read(&entry, &below(path, name), modules);
            continue;
        }
        files += 1;
        let module = if ["lib", "mod"].contains(&name) { path.into() } else { below(path, name) };
        if module != "main" {
            modules.insert(module, code(&std::fs::read_to_string(&entry).unwrap()));
        }
    }
    assert!(files <= MOST_FILES, "{} holds {files} files", folder.display());
}

/// The path of a module below another.
pub fn below(module: &str, name: &str) -> String {
    if module.is_empty() { name.into() } else { format!("{module}::{name}") }
}

/// A file without comments and tests.
pub fn code(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// The paths that a text begins with, groups in braces taken apart, and what follows.
fn paths(text: &str) -> (Vec<String>, &str) {
    let text = text.trim_start();
    if let Some(mut rest) = text.strip_prefix('{') {
        let mut all = Vec::new();
        loop {
            let (some, after) = paths(rest);
            all.extend(some);
            let Some(at) = after.find([',', '}']) else { return (all, "") };
            rest = &after[at + 1..];
            if after[at..].starts_with('}') {
                return (all, rest);
            }
        }
    }
    let (name, rest) = text.split_at(text.find(|c| !is_word(c)).unwrap_or(text.len()));
    let (further, rest) = rest.strip_prefix("::").map_or((Vec::new(), rest), paths);
    match further.is_empty() {
        true if name.is_empty() => (further, rest),
        true => (vec![name.into()], rest),
        false => (further.iter().map(|path| format!("{name}::{path}")).collect(), rest),
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether what a module only passes on (`pub use`) counts.
#[derive(PartialEq)]
pub enum Passing {
    Counted,
    LeftOut,
}

/// The paths into its own crate that a module names.
pub fn own_paths(modules: &Modules, module: &str, passing: Passing) -> Vec<String> {
    let statements = modules[module].split_inclusive(';');
    let is_passed = |text: &&str| text.trim_start().starts_with("pub use ");
    let counted = statements.filter(|text| passing == Passing::Counted || !is_passed(text));
    let code: String = counted.collect();
    let prefix = below(module, "");
    let children = modules.keys().filter_map(|other| other.strip_prefix(&prefix));
    let roots = children.filter(|child| !child.contains("::")).chain(["crate", "self", "super"]);
    let mut all = Vec::new();
    for root in roots.filter(|root| !root.is_empty()).map(|root| format!("{root}::")) {
        let inside = |c| is_word(c) || c == ':' || c == '$';
        let starts = code.match_indices(&root).filter(|(at, _)| !code[..*at].ends_with(inside));
        all.extend(starts.flat_map(|(at, _)| paths(&code[at..]).0));
    }
    all
}
