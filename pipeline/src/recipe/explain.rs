//! What serde says about a value, in words for the author of a config.

use std::ops::Range;

use octruss_base::suggestion::suggestion;
use serde::Deserialize;
use toml::de::{DeValue, Error, ValueDeserializer};

use super::tree::Tree;
use crate::error::{ConfigError, Source};

/// Reads a value; `stage` is the label of the stage that it is in.
///
/// # Errors
/// As serde's, explained.
pub fn deserialize<'de, T: Deserialize<'de>>(
    tree: Tree<'de>,
    stage: Option<&str>,
    source: &Source,
) -> Result<T, ConfigError> {
    T::deserialize(ValueDeserializer::from(tree.clone()))
        .map_err(|error| explain(&error, &tree, stage, source))
}

/// An error of deserialisation with its place, its key and, for an unknown
/// name, the nearest valid one. `stage` is the label of the stage being read.
fn explain(error: &Error, tree: &Tree, stage: Option<&str>, source: &Source) -> ConfigError {
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
        ("expected struct MaterialKeys", "expected a table such as { young = 1, poisson = 0.3 }"),
        ("expected a boolean", "expected true or false"),
        ("expected a sequence", "expected a list"),
        ("expected a map", "expected a table"),
        ("floating point ", "number "),
    ];
    words.iter().fold(message.trim_end().into(), |text, (rust, plain)| text.replace(rust, plain))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::num::NonZeroU8;

    use serde::Deserialize;

    use super::{in_plain_words, quoted_names};
    use crate::options::Compare;

    #[derive(Debug, Default, Deserialize)]
    #[serde(deny_unknown_fields, default)]
    #[allow(dead_code, reason = "only the errors of reading it matter")]
    struct Values {
        nonzero: Option<NonZeroU8>,
        byte: u8,
        small: u32,
        count: usize,
        number: f64,
        flag: bool,
        list: Vec<u8>,
        table: BTreeMap<String, u8>,
        compare: Compare,
        choice: Option<Choice>,
        needy: Option<Needy>,
    }

    #[derive(Debug, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    enum Choice {
        Left,
        Right,
    }

    #[derive(Debug, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    #[allow(dead_code, reason = "only the errors of reading it matter")]
    struct Needy {
        needed: u8,
    }

    fn said(text: &str) -> String {
        toml::from_str::<Values>(text).unwrap_err().message().trim_end().into()
    }

    /// `explain` takes messages of serde and toml apart. Where an upgrade words one
    /// anew, this fails, and the words that `explain` looks for are to follow.
    #[test]
    fn serde_words_its_errors_as_they_are_taken_apart() {
        let wordings = [
            ("needy = {}", "missing field `needed`", "missing field `needed`"),
            (
                "nonzero = 0",
                "invalid value: integer `0`, expected a nonzero u8",
                "found integer `0`, expected a whole number from 1 to 255",
            ),
            (
                "byte = 256",
                "invalid value: integer `256`, expected u8",
                "found integer `256`, expected a whole number from 0 to 255",
            ),
            (
                "small = -1",
                "invalid value: integer `-1`, expected u32",
                "found integer `-1`, expected a whole number, 0 or more",
            ),
            (
                "count = 1.5",
                "invalid type: floating point `1.5`, expected usize",
                "found number `1.5`, expected a whole number, 0 or more",
            ),
            (
                "number = true",
                "invalid type: boolean `true`, expected f64",
                "found boolean `true`, expected a number",
            ),
            (
                "flag = \"on\"",
                "invalid type: string \"on\", expected a boolean",
                "found string \"on\", expected true or false",
            ),
            (
                "list = 1",
                "invalid type: integer `1`, expected a sequence",
                "found integer `1`, expected a list",
            ),
            (
                "table = 1",
                "invalid type: integer `1`, expected a map",
                "found integer `1`, expected a table",
            ),
            (
                "compare = 1",
                "invalid type: integer `1`, expected struct Compare",
                "found integer `1`, expected a table [compare]",
            ),
        ];
        for (text, raw, plain) in wordings {
            let said = said(text);
            assert_eq!(said, raw, "serde's wording changed: `explain` relies on it");
            assert_eq!(in_plain_words(&said), plain);
        }
    }

    /// The first name is the one found, the others are those that are valid.
    #[test]
    fn serde_lists_names_as_they_are_taken_apart() {
        let unknown = said("nunber = 1");
        assert!(unknown.starts_with("unknown field "), "{unknown}");
        assert_eq!(quoted_names(&unknown)[..3], ["nunber", "nonzero", "byte"], "{unknown}");
        let unknown = said("choice = \"middle\"");
        assert!(unknown.starts_with("unknown variant "), "{unknown}");
        assert_eq!(quoted_names(&unknown), ["middle", "left", "right"], "{unknown}");
    }
}
