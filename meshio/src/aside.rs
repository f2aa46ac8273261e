//! Files appear whole or not at all: written aside, then renamed.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use crate::error::Error;

/// Writes the file at `path` by `content`, first under a passing name in the
/// same folder, then renamed over whatever was there.
///
/// A new file gets the usual permissions of the user, a replaced one keeps its
/// own. If anything fails, the old file stays as it was and nothing is left behind.
///
/// # Errors
/// [`Error::Io`] naming the folder if it is missing or not writable, and the
/// file if writing or renaming fails.
///
/// ```
/// use std::io::Write;
/// let folder = tempfile::tempdir().unwrap();
/// let path = folder.path().join("note.txt");
/// octruss_meshio::write_aside(&path, |file| file.write_all(b"done")).unwrap();
/// assert_eq!(std::fs::read(&path).unwrap(), b"done");
/// ```
pub fn write_aside(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<&mut File>) -> io::Result<()>,
) -> Result<(), Error> {
    let mut file = create_beside(path)?;
    let written = {
        let mut writer = BufWriter::new(file.as_file_mut());
        content(&mut writer).and_then(|()| writer.flush())
    };
    written.map_err(|source| Error::io(path, source))?;
    file.persist(path).map_err(|failure| Error::io(path, failure.error))?;
    Ok(())
}

/// Makes sure, before long work, that a file can be written at `path`; leaves no trace.
///
/// # Errors
/// As [`write_aside`] when it begins; [`Error::Io`] if there is a folder at `path`.
pub(crate) fn check_place(path: &Path) -> Result<(), Error> {
    if path.is_dir() {
        return Err(Error::io(path, io::ErrorKind::IsADirectory.into()));
    }
    create_beside(path).map(drop)
}

fn create_beside(path: &Path) -> Result<tempfile::NamedTempFile, Error> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    create_in(folder, path).map_err(|source| refused(folder, source))
}

fn create_in(folder: &Path, path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".unfinished-");
    // By default such files are for their owner alone; 0o666 lets the umask decide.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder)?;
    if let Ok(old) = std::fs::metadata(path)
        && old.is_file()
    {
        file.as_file().set_permissions(old.permissions())?;
    }
    Ok(file)
}

fn refused(folder: &Path, source: io::Error) -> Error {
    let reason = match source.kind() {
        io::ErrorKind::NotFound => "the folder does not exist; create it first".to_string(),
        io::ErrorKind::NotADirectory => "this is not a folder".to_string(),
        _ => format!("cannot write in this folder: {source}"),
    };
    Error::io(folder, io::Error::new(source.kind(), reason))
}
