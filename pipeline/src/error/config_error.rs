//! What can be wrong with a config.

use std::fmt;
use std::path::PathBuf;

/// A config that cannot be run: where, what was found, what is possible.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{place}: {message}")]
pub struct ConfigError {
    /// Where the mistake is.
    pub place: ConfigPlace,
    /// What was found, what was expected, what to do.
    pub message: String,
}

/// A place in a config, as a user can find it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ConfigPlace {
    /// The file as a whole.
    File(PathBuf),
    /// A line and a column, both counted from 1.
    Line {
        /// The config file.
        path: PathBuf,
        /// From 1.
        line: usize,
        /// From 1, in characters.
        column: usize,
    },
    /// A `--set` of the command line.
    Override {
        /// As it was typed.
        typed: String,
    },
}

impl fmt::Display for ConfigPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(path) => write!(f, "{}", path.display()),
            Self::Line { path, line, column } => {
                write!(f, "{}:{line}:{column}", path.display())
            }
            Self::Override { typed } => write!(f, "--set {typed}"),
        }
    }
}
