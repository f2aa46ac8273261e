//! What serde says about a value, in words for the author of a config.

use std::ops::Range;

use toml::de::{DeValue, Error};

use super::error::ConfigError;
use super::nearest::suggestion;
use super::source::Source;
use super::tree::Tree;

/// An error of deserialisation with its place, its key and, for an unknown
/// name, the nearest valid one. `stage` is the label of the stage being read.
pub fn explain(error: &Error, tree: &Tree, stage: Option<&str>, source: &Source) -> ConfigError {
    let span = error.span().unwrap_or_else(|| tree.span());
    let place = stage.map_or_else(String::new, |label| format!(" in stage `{label}`"));
    let message = error.message();
    let unknown = [("unknown field", "key"), ("unknown variant", "value")]
        .into_iter()
        .find(|(start, _)| message.starts_with(start));
    let message = if let Some((_, what)) = unknown {
        let names = quoted_names(message);
        let (found, valid) = names.split_first().unwrap_or((&"", &[]));
        format!("unknown {what} `{found}`{place}{}", suggestion(found, valid))
    } else if let Some(rest) = message.strip_prefix("missing field") {
        format!("missing key{rest}{place}")
    } else {
        let key = key_at(tree, &span).map_or_else(String::new, |key| format!("`{key}`{place}: "));
        format!("{key}{}", in_plain_words(message))
    };
    source.error(&span, message)
}

/// The names in backquotes: serde lists the one found, then the valid ones.
fn quoted_names(message: &str) -> Vec<&str> {
    message.split('`').skip(1).step_by(2).collect()
}

/// The innermost key whose value has this place.
fn key_at<'t>(tree: &'t Tree, span: &Range<usize>) -> Option<&'t str> {
    match tree.get_ref() {
        DeValue::Table(table) => table.iter().find_map(|(key, value)| {
            key_at(value, span).or_else(|| (value.span() == *span).then(|| key.get_ref().as_ref()))
        }),
        DeValue::Array(entries) => entries.iter().find_map(|entry| key_at(entry, span)),
        _ => None,
    }
}

/// Names of Rust types replaced by what a config may hold.
fn in_plain_words(message: &str) -> String {
    let words = [
        ("invalid type: ", "found "),
        ("invalid value: ", "found "),
        ("expected a nonzero u8", "expected a whole number from 1 to 255"),
        ("expected u8", "expected a whole number from 0 to 255"),
        ("expected u32", "expected a whole number, 0 or more"),
        ("expected usize", "expected a whole number, 0 or more"),
        ("expected f64", "expected a number"),
        ("expected struct Compare", "expected a table [compare]"),
        ("expected a boolean", "expected true or false"),
        ("expected a sequence", "expected a list"),
        ("expected a map", "expected a table"),
        ("floating point ", "number "),
    ];
    words.iter().fold(message.trim_end().into(), |text, (rust, plain)| text.replace(rust, plain))
}
