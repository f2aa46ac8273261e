//! The output folder and what goes there.

use std::path::{Path, PathBuf};

use octruss_meshio::{Dataset, Format, vtu};

use crate::error::Error;

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

/// What a run did.
pub const REPORT: &str = "report.json";

/// The best iterate of a solve that did not reach its goal.
pub const UNFINISHED: &str = "unfinished.vtu";

/// Removes `report.json` and `unfinished.vtu` of an earlier run, so that none is
/// left to be taken for that of this one.
///
/// # Errors
/// If there is one that the system does not let go.
pub fn remove_earlier(folder: &Path) -> Result<(), Error> {
    remove(folder, &[REPORT, UNFINISHED])
}

/// Removes files of these names, where they are.
///
/// # Errors
/// If there is one that the system does not let go.
pub fn remove(folder: &Path, names: &[&str]) -> Result<(), Error> {
    for name in names {
        let path = folder.join(name);
        match std::fs::remove_file(&path) {
            Err(error) if path.exists() => {
                return Err(Error::Output { path, reason: error.to_string() });
            }
            _ => {}
        }
    }
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

/// Writes a mesh file and, beside a `.vtu` of a mesh with tagged surfaces, these
/// as `NAME.surfaces.vtu`; returns the files.
///
/// # Errors
/// As [`octruss_meshio::write()`].
pub fn write_with_surfaces(path: &Path, dataset: &Dataset) -> Result<Vec<PathBuf>, Error> {
    octruss_meshio::write(path, dataset)?;
    let mut files = vec![path.to_path_buf()];
    if Format::of(path)? == vtu::FORMAT && !dataset.mesh.triangles.is_empty() {
        let beside = vtu::surfaces_path(path);
        vtu::write_surfaces(&beside, dataset)?;
        files.push(beside);
    }
    Ok(files)
}
