//! What is wrong with some bytes, before anybody says which file they came from.

use std::path::Path;

use crate::error::{Error, Place};

/// An [`Error`] that lacks its path: parsers see bytes, not files.
#[derive(Debug)]
pub(crate) enum Problem {
    /// See [`Error::Malformed`].
    Malformed(Place, String),
    /// See [`Error::Unsupported`].
    Unsupported(String),
}

impl Problem {
    /// The content as a whole is wrong.
    pub(crate) fn whole(message: impl Into<String>) -> Self {
        Self::Malformed(Place::Whole, message.into())
    }

    /// A named part is wrong.
    pub(crate) fn part(part: impl Into<String>, message: impl Into<String>) -> Self {
        Self::Malformed(Place::Part(part.into()), message.into())
    }

    /// The content may be right but is not handled.
    pub(crate) fn unsupported(message: impl Into<String>) -> Self {
        Self::Unsupported(message.into())
    }

    /// The error about the file at `path`.
    pub(crate) fn of(self, path: &Path) -> Error {
        match self {
            Self::Malformed(place, message) => Error::malformed(path, place, message),
            Self::Unsupported(message) => Error::unsupported(path, message),
        }
    }
}
