//! What can go wrong with a file.

use std::path::{Path, PathBuf};

/// A file that could not be read or written, with the place and what to do.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The system refused: no such file, no permission, disk full.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// The content is not what its format prescribes.
    #[error("{}{place}: {message}", path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// Where in it.
        place: Place,
        /// What was found, what was expected, what to do.
        message: String,
    },
    /// The file may be right, but holds what this program does not handle.
    #[error("{}: {message}", path.display())]
    Unsupported {
        /// The file.
        path: PathBuf,
        /// What it is, and what to do instead.
        message: String,
    },
}

/// A place in a file, as a user can find it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// No particular place.
    Whole,
    /// A line, counted from 1.
    Line(usize),
    /// A byte, counted from 0, in a binary part.
    Byte(usize),
    /// A named part, such as an array or a section.
    Part(String),
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Whole => Ok(()),
            Self::Line(line) => write!(f, ":{line}"),
            Self::Byte(byte) => write!(f, " at byte {byte}"),
            Self::Part(part) => write!(f, " in {part}"),
        }
    }
}

impl Error {
    /// Wraps a refusal of the system.
    pub fn io(path: &Path, source: std::io::Error) -> Self {
        Self::Io { path: path.into(), source }
    }

    /// A malformed file.
    pub fn malformed(path: &Path, place: Place, message: impl Into<String>) -> Self {
        Self::Malformed { path: path.into(), place, message: message.into() }
    }

    /// A file or request that is not handled.
    pub fn unsupported(path: &Path, message: impl Into<String>) -> Self {
        Self::Unsupported { path: path.into(), message: message.into() }
    }
}
