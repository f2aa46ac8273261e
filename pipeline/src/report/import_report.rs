//! What reading a mesh file brought.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::amount::short;

/// What was read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ImportReport {
    /// The file.
    pub path: PathBuf,
    /// Points in the file.
    pub vertices: usize,
    /// Tets in the file.
    pub tets: usize,
    /// What the reader left out or changed.
    pub notes: Vec<String>,
}

impl ImportReport {
    /// The outcome in a line.
    pub fn summary(&self) -> String {
        let (vertices, tets) = (short(self.vertices), short(self.tets));
        format!("{}: {vertices} vertices, {tets} tets", self.path.display())
    }
}
