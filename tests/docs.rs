//! The documentation: every scheme has its page, and what pages point to is there.

mod common;

use std::path::{Path, PathBuf};

use common::{files, repository};
use octruss_mesh::Scheme;

/// The Markdown files of the repository's root and of `docs`.
fn pages() -> Vec<PathBuf> {
    let docs = repository("docs");
    let below = files(&docs).into_iter().map(|name| docs.join(name));
    let root = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(repository);
    below.chain(root).filter(|path| path.extension().is_some_and(|end| end == "md")).collect()
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap()
}

/// The parts of a text between an opening and the next closing.
fn between<'a>(text: &'a str, open: &'a str, close: char) -> impl Iterator<Item = &'a str> {
    text.split(open).skip(1).filter_map(move |rest| rest.split_once(close).map(|(part, _)| part))
}

/// The names by which GitHub links to the headings of a page.
fn anchors(page: &str) -> Vec<String> {
    let headings = page.lines().filter(|line| line.starts_with('#'));
    let plain = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
    headings
        .map(|line| line.trim_start_matches('#').trim().to_lowercase())
        .map(|heading| heading.chars().filter(plain).collect::<String>().replace(' ', "-"))
        .collect()
}

#[test]
fn every_scheme_has_its_row_and_a_page_with_pictures() {
    let index = text(&repository("docs/schemes/README.md"));
    for scheme in Scheme::ALL {
        let name = format!("`{}`", scheme.name());
        let row = index.lines().find(|line| line.starts_with("| [") && line.contains(&name));
        let row = row.unwrap_or_else(|| panic!("{name} has no row in docs/schemes/README.md"));
        let page = text(&repository("docs/schemes").join(between(row, "](", ')').next().unwrap()));
        assert!(page.contains(&name), "the page of {name} does not name it");
        for kind in ["masks", "basis"] {
            let picture = format!("{}-{kind}.png", scheme.name());
            assert!(page.contains(&picture), "the page of {name} lacks {picture}");
        }
    }
}

#[test]
fn links_lead_to_files_and_headings() {
    let mut links = 0;
    for page in pages() {
        let content = text(&page);
        for link in between(&content, "](", ')').filter(|link| !link.contains("://")) {
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let target = match file {
                "" => page.clone(),
                _ => page.parent().unwrap().join(file),
            };
            assert!(target.exists(), "{}: no {link}", page.display());
            let known =
                heading.is_empty() || anchors(&text(&target)).contains(&heading.to_string());
            assert!(known, "{}: no heading {link}", page.display());
            links += 1;
        }
    }
    assert!(links > 50, "{links} links found");
}

#[test]
fn tests_that_pages_name_exist() {
    let mut named = 0;
    for page in pages().into_iter().filter(|page| page.parent().unwrap().ends_with("schemes")) {
        let content = text(&page);
        let codes = content.split('`').skip(1).step_by(2);
        for (file, test) in codes.filter_map(|code| code.split_once("::")) {
            let source = repository("mesh/tests").join(file).with_extension("rs");
            assert!(source.exists(), "{}: no {file}::{test}", page.display());
            let found = text(&source).contains(&format!("fn {test}("));
            assert!(found, "{}: no test {test} in {}", page.display(), source.display());
            named += 1;
        }
    }
    assert!(named > 30, "{named} tests named");
}
