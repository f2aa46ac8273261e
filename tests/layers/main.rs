//! What builds on what: within a crate, neither the modules at its top nor single files
//! lean on each other in a circle, and no folder is a hall of files.

mod code;
#[path = "../common/mod.rs"]
mod common;

use std::collections::{BTreeMap, BTreeSet};

use code::{Modules, Passing, below, code, own_paths, read};
use common::repository;

const CRATES: [&str; 6] = ["base", "mesh", "meshio", "solver", "fem", "pipeline"];

/// What leans on what.
type Graph = BTreeMap<String, BTreeSet<String>>;

/// The module that a path, seen from a module, leads to; a name that is passed on is
/// followed for some steps.
fn target(modules: &Modules, from: &str, path: &str, steps: usize) -> Option<String> {
    let mut at = from.to_string();
    for name in path.split("::") {
        let child = below(&at, name);
        match name {
            "crate" => at.clear(),
            "self" => {}
            "super" => at.truncate(at.rfind("::").unwrap_or(0)),
            _ if modules.contains_key(&child) => at = child,
            _ => {
                let passed_on = own_paths(modules, &at, Passing::Counted);
                let found = passed_on.iter().find(|path| path.ends_with(&format!("::{name}")));
                let Some(found) = found else { return Some(at) };
                return target(modules, &at, found, steps.checked_sub(1)?);
            }
        }
    }
    Some(at)
}

/// Which files lean on which. What a file only passes on, it does not lean on.
fn between_files(modules: &Modules) -> Graph {
    let leans = |module: &String| {
        let paths = own_paths(modules, module, Passing::LeftOut);
        let targets = paths.iter().filter_map(|path| target(modules, module, path, 8));
        targets.filter(|other| other != module && !other.is_empty()).collect()
    };
    let nodes = modules.keys().filter(|module| !module.is_empty());
    nodes.map(|module| (module.clone(), leans(module))).collect()
}

/// The same between the modules at the top of the crate.
fn between_tops(files: &Graph) -> Graph {
    let top = |module: &String| module.split("::").next().unwrap_or_default().to_string();
    let mut tops = Graph::new();
    for (from, to) in files {
        let others = to.iter().map(top).filter(|other| *other != top(from));
        tops.entry(top(from)).or_default().extend(others);
    }
    tops
}

/// The first circle that is found from here on, as the way round.
fn circle(graph: &Graph, way: &mut Vec<String>, done: &mut BTreeSet<String>) -> bool {
    let (here, before) = way.split_last().expect("the way begins somewhere");
    if let Some(at) = before.iter().position(|node| node == here) {
        way.drain(..at);
        return true;
    }
    let here = here.clone();
    let next = graph[&here].iter().any(|next| {
        way.push(next.clone());
        let found = !done.contains(next) && circle(graph, way, done);
        if !found {
            way.pop();
        }
        found
    });
    done.insert(here);
    next
}

fn first_circle(graph: &Graph) -> Option<String> {
    let mut done = BTreeSet::new();
    graph.keys().find_map(|start| {
        let mut way = vec![start.clone()];
        circle(graph, &mut way, &mut done).then(|| way.join(" → "))
    })
}

#[test]
fn nothing_leans_on_itself_in_a_circle() {
    let mut circles = Vec::new();
    for name in CRATES {
        let mut modules = Modules::new();
        read(&repository(name).join("src"), "", &mut modules);
        let files = between_files(&modules);
        let found = first_circle(&between_tops(&files)).or_else(|| first_circle(&files));
        circles.extend(found.map(|way| format!("{name}: {way}")));
    }
    assert!(circles.is_empty(), "in a circle:\n{}", circles.join("\n"));
}

#[test]
fn a_circle_is_found_and_named() {
    let modules = [
        ("", "pub mod a;\npub mod b;\npub use b::Other;"),
        ("a", "mod low;\npub use low::{Low as Lower, Lowest};"),
        ("a::low", "use crate::{Other, b::{self}};\nfn f() {}"),
        ("b", "// crate::a::Lower\nuse std::fmt;\nfn other() { super::a::Lowest::new() }"),
        ("c", "#[cfg(test)]\nmod tests {\n    use crate::d::D;\n}"),
        ("d", "use crate::c::C;\nstruct D;"),
    ];
    let modules = modules.map(|(path, text)| (path.to_string(), code(text))).into();
    let files = between_files(&modules);
    assert_eq!(first_circle(&files).unwrap(), "a::low → b → a::low");
    assert_eq!(first_circle(&between_tops(&files)).unwrap(), "a → b → a");
}
