//! PVD, ParaView's list of files over time.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use quick_xml::escape::escape;

use crate::aside::write_aside;
use crate::error::Error;

/// Writes a `.pvd` file that lists files with their times, in the order given.
///
/// File names are relative to the folder of `path`. The times may be anything
/// finite that orders the files, such as refinement levels.
///
/// # Errors
/// [`Error::Io`] if the folder or file cannot be written; [`Error::Unsupported`]
/// if a time is not finite.
///
/// ```
/// let folder = tempfile::tempdir().unwrap();
/// let path = folder.path().join("levels.pvd");
/// octruss_meshio::pvd::write(&path, &[(0.0, "a.vtu".into()), (1.0, "b.vtu".into())]).unwrap();
/// let text = std::fs::read_to_string(&path).unwrap();
/// assert!(text.contains("<DataSet timestep=\"1\" part=\"0\" file=\"b.vtu\"/>"));
/// ```
pub fn write(path: &Path, entries: &[(f64, String)]) -> Result<(), Error> {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n",
    );
    for (time, file) in entries {
        if !time.is_finite() {
            return Err(Error::unsupported(
                path,
                format!("the time {time} of {file} is not finite"),
            ));
        }
        let file = escape(file.as_str());
        // Writing to a String cannot fail.
        let _ = writeln!(text, "    <DataSet timestep=\"{time}\" part=\"0\" file=\"{file}\"/>");
    }
    text.push_str("  </Collection>\n</VTKFile>\n");
    write_aside(path, |out| out.write_all(text.as_bytes()))
}
