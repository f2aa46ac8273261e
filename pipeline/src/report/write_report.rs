//! What was written.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::amount;

/// What was written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WriteReport {
    /// Every file, in the order of writing.
    pub files: Vec<PathBuf>,
    /// The size of all together.
    pub bytes: u64,
    /// Files of an earlier run that were removed, since this one has none like them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub removed: Vec<PathBuf>,
    /// Fields whose names were needed.
    pub notes: Vec<String>,
}

impl WriteReport {
    /// The outcome in a line.
    pub fn summary(&self) -> String {
        let folder = self.files.first().and_then(|file| file.parent()).unwrap_or(Path::new(""));
        let (count, bytes) = (self.files.len(), amount::bytes(self.bytes));
        let removed = match self.removed.len() {
            0 => String::new(),
            stale => format!(", {stale} of an earlier run removed"),
        };
        format!("{count} files in {}, {bytes}{removed}", folder.display())
    }
}
