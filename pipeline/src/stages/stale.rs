//! Files that the stage `write` left in an earlier run and did not write again.

use std::path::{Path, PathBuf};

use super::file_names::is_own;
use crate::error::Error;

/// Removes from a folder the files with names that the stage gives, but those
/// `written` in this run and the file `read` in it, so that none is taken for one of
/// this run; returns them in order. Anything else stays.
///
/// # Errors
/// If the folder cannot be read, or a file not be removed.
pub(super) fn remove_stale(
    folder: &Path,
    written: &[PathBuf],
    read: &Path,
) -> Result<Vec<PathBuf>, Error> {
    let refused = |path: &Path, error: std::io::Error| Error::Output {
        path: path.into(),
        reason: error.to_string(),
    };
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let entries = entries.map_err(|error| refused(folder, error))?;
    let is_stale = |entry: &std::fs::DirEntry| {
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        is_file && entry.file_name().to_str().is_some_and(is_own)
    };
    let stale = entries.into_iter().filter(is_stale).map(|entry| entry.path());
    // By whatever path they were named.
    let input = read.canonicalize().ok();
    let is_input = |path: &PathBuf| input.is_some() && path.canonicalize().ok() == input;
    let is_kept = |path: &PathBuf| written.contains(path) || is_input(path);
    let mut stale: Vec<PathBuf> = stale.filter(|path| !is_kept(path)).collect();
    stale.sort();
    for path in &stale {
        std::fs::remove_file(path).map_err(|error| refused(path, error))?;
    }
    Ok(stale)
}
