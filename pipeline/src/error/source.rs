//! The text of a config with its overrides, and the places in it.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::config_error::{ConfigError, ConfigPlace};

/// A config file and the overrides of the command line as one numbered text,
/// so that any byte range says where it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct Source {
    path: PathBuf,
    text: String,
    overrides: Vec<Override>,
}

/// One `key=value` of the command line.
#[derive(Debug, Clone, PartialEq)]
pub struct Override {
    /// As it was typed.
    pub typed: String,
    /// `value = …`, moved behind the file and the overrides before by spaces,
    /// so that places in it are numbers of the common text.
    pub numbered: String,
    start: usize,
}

impl Override {
    fn new(typed: &str, start: usize) -> Self {
        let value = typed.split_once('=').map_or("", |(_, value)| value.trim());
        let numbered = format!("{:start$}value = {value}", "");
        Self { typed: typed.into(), numbered, start }
    }

    /// Its first number in the common text.
    pub fn span(&self) -> Range<usize> {
        self.start..self.start + 1
    }
}

impl Source {
    /// Numbers the file's bytes from 0 and those of the overrides after them.
    pub fn new(path: PathBuf, text: String, overrides: &[String]) -> Self {
        let mut start = text.len() + 1;
        let overrides = overrides
            .iter()
            .map(|typed| {
                let next = Override::new(typed, start);
                start = next.numbered.len() + 1;
                next
            })
            .collect();
        Self { path, text, overrides }
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The file's text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The overrides, in the order of the command line.
    pub fn overrides(&self) -> &[Override] {
        &self.overrides
    }

    /// Where the first byte of a range is, in words for a user.
    pub fn place(&self, span: &Range<usize>) -> ConfigPlace {
        let typed = self.overrides.iter().rev().find(|typed| typed.start <= span.start);
        if let Some(found) = typed {
            return ConfigPlace::Override { typed: found.typed.clone() };
        }
        let before = self.text.get(..span.start).unwrap_or(&self.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        ConfigPlace::Line {
            path: self.path.clone(),
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
        }
    }

    /// An error at a byte range.
    pub fn error(&self, span: &Range<usize>, message: impl Into<String>) -> ConfigError {
        ConfigError { place: self.place(span), message: message.into() }
    }
}
