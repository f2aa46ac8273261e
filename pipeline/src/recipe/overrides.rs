//! `--set key=value`: one value of a config, replaced before it is read.
//!
//! A key is a path of names joined by dots, as in the config: `name`,
//! `stage.subdivide.levels`, `stage.solve.fixed.0.value`, `expect`. A stage goes
//! by its label: its kind, and from the second stage of a kind on with its
//! number (`solve`, `solve-2`). Entries of other lists are counted from 0. The
//! value is TOML; what is not, is a string, so that names need no quotes.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::labels::labels_of_trees;
use super::tree::Tree;
use crate::error::{ConfigError, Override, Source};
use octruss_base::suggestion::suggestion;

/// Puts one override into a parsed config.
///
/// # Errors
/// No `=`, a malformed key, a path through something that has no such entry.
/// A last key that no stage knows is refused later, when the stage is read.
pub fn apply<'a>(
    root: &mut Tree<'a>,
    given: &'a Override,
    source: &Source,
) -> Result<(), ConfigError> {
    let fail = |message: String| source.error(&given.span(), message);
    let Some((key, value)) = given.typed.split_once('=') else {
        return Err(fail("expected KEY=VALUE".into()));
    };
    let path = key_names(key.trim())
        .ok_or_else(|| fail(format!("`{key}` is not a key: names joined by dots")))?;
    let mut place = root;
    for (depth, name) in path.iter().enumerate() {
        place = step(place, &path[..depth], name, given).map_err(fail)?;
    }
    *place = parse_value(value.trim(), given);
    Ok(())
}

/// Goes one name deeper, making an empty table where a key is missing.
fn step<'a, 't>(
    place: &'t mut Tree<'a>,
    walked: &[String],
    name: &str,
    given: &Override,
) -> Result<&'t mut Tree<'a>, String> {
    match place.get_mut() {
        DeValue::Table(table) => {
            let key = Spanned::new(given.span(), DeString::from(name.to_string()));
            // Taken out and put back, so that the key's place is the override's.
            let value = table.remove(&key);
            let empty = || Spanned::new(given.span(), DeValue::Table(DeTable::new()));
            Ok(table.entry(key).or_insert(value.unwrap_or_else(empty)))
        }
        DeValue::Array(entries) => {
            let index = entry_index(entries, walked, name)?;
            let (list, count) = (walked.join("."), entries.len());
            entries.get_mut(index).ok_or_else(|| {
                format!("`{list}` has {count} entries, counted from 0, none is `{name}`")
            })
        }
        other => {
            let found = other.type_str();
            Err(format!("`{}` is one {found}, no table with keys", walked.join(".")))
        }
    }
}

/// Which entry of a list a name means: a stage by its label, others by number.
fn entry_index(entries: &[Tree], walked: &[String], name: &str) -> Result<usize, String> {
    if walked != ["stage"] {
        // What is no number is the number of no entry.
        return Ok(name.parse().unwrap_or(usize::MAX));
    }
    let labels = labels_of_trees(entries);
    let labels: Vec<&str> = labels.iter().map(String::as_str).collect();
    let found = labels.iter().position(|&label| label == name);
    found.ok_or_else(|| format!("unknown stage `{name}`{}", suggestion(name, &labels)))
}

/// The names of a dotted key, quoted ones included.
fn key_names(key: &str) -> Option<Vec<String>> {
    let line = format!("{key} = 0");
    let document = DeTable::parse(&line).ok()?;
    let mut table = document.get_ref();
    let mut names = Vec::new();
    loop {
        let (name, value) = table.iter().next()?;
        names.push(name.get_ref().to_string());
        match value.get_ref() {
            DeValue::Table(inner) => table = inner,
            _ => return Some(names),
        }
    }
}

/// The value as TOML, or as a string if it is none.
fn parse_value<'a>(text: &'a str, given: &'a Override) -> Tree<'a> {
    DeTable::parse(&given.numbered)
        .ok()
        .and_then(|table| table.into_inner().into_iter().next())
        .map_or_else(
            || Spanned::new(given.span(), DeValue::String(text.into())),
            |(_, value)| value,
        )
}
