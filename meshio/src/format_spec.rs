//! What there is to know about a format.

use std::path::Path;

use crate::dataset::Dataset;
use crate::error::Error;
use crate::problem::Problem;

/// Writes a dataset to a path.
type WriteFile = fn(&Path, &Dataset) -> Result<(), Error>;

/// A mesh format, described in one constant beside its reader and writer.
pub struct FormatSpec {
    /// What its files are called in messages, as in "Gmsh files".
    pub(crate) name: &'static str,
    /// The extension of its files, in small letters, without a dot.
    pub(crate) extension: &'static str,
    /// How its files may begin.
    pub(crate) signatures: &'static [&'static str],
    /// Whether `read` itself says what an empty file is, and one that begins
    /// like another format; else both are refused before it is asked.
    pub(crate) tells_strangers: bool,
    /// The dataset in the bytes of a file.
    pub(crate) read: fn(&[u8]) -> Result<Dataset, Problem>,
    /// Writes a file, whole or not at all; `None` for a format that is only read.
    pub(crate) write: Option<WriteFile>,
    /// What a file cannot hold of a dataset, a sentence each.
    pub(crate) losses: fn(&Dataset) -> Vec<String>,
}
