//! The output folder.

use std::io::Write;
use std::path::Path;

use octruss_meshio::write_aside;

use crate::error::Error;
use crate::report::Report;

/// Makes sure, before hours of work, that a folder can be made or written,
/// without leaving a trace.
///
/// # Errors
/// If the path, or what exists of it, is no folder or does not accept a file.
pub fn check_folder(folder: &Path) -> Result<(), Error> {
    let refused = |path: &Path, reason: String| Error::Output { path: path.into(), reason };
    let existing = folder.ancestors().find(|path| path.exists());
    // The empty path is the last ancestor of a relative one.
    let existing = existing.filter(|path| !path.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !existing.is_dir() {
        return Err(refused(existing, "it is a file, not a folder".into()));
    }
    tempfile::tempfile_in(existing).map_err(|error| refused(existing, error.to_string()))?;
    Ok(())
}

/// Makes the output folder.
///
/// # Errors
/// If the system refuses.
pub fn create_folder(folder: &Path) -> Result<(), Error> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Error::Output { path: folder.into(), reason: error.to_string() })
}

/// Writes `report.json`.
///
/// # Errors
/// If the folder cannot be made or the file not be written.
pub fn write_report(folder: &Path, report: &Report) -> Result<(), Error> {
    create_folder(folder)?;
    let text = serde_json::to_string_pretty(report).expect("a report has only string keys");
    write_aside(&folder.join("report.json"), |file| writeln!(file, "{text}"))?;
    Ok(())
}
