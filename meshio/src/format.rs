//! Which file is which: formats by extension, and what each can do.

use std::path::Path;

use crate::dataset::Dataset;
use crate::error::Error;
use crate::problem::Problem;
use crate::{aside, gmsh, legacy, vtu};

/// The mesh formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Gmsh's `.msh`, read only.
    Gmsh,
    /// VTK's XML format for unstructured grids, `.vtu`: holds all of a dataset but corner fields.
    Vtu,
    /// VTK's older format, `.vtk`: holds no group names, no features, and not which
    /// fields are derived.
    LegacyVtk,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 3] = [Self::Gmsh, Self::Vtu, Self::LegacyVtk];

    /// The extension of its files, without a dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Gmsh => "msh",
            Self::Vtu => "vtu",
            Self::LegacyVtk => "vtk",
        }
    }

    /// Whether [`write()`] can write it; [`read`] reads all formats.
    pub fn writes(self) -> bool {
        !matches!(self, Self::Gmsh)
    }

    /// How files of the format may begin.
    fn signatures(self) -> &'static [&'static str] {
        match self {
            Self::Gmsh => &["$MeshFormat"],
            Self::Vtu => &["<VTKFile", "<?xml"],
            Self::LegacyVtk => &["# vtk DataFile"],
        }
    }

    /// The format of a file by its extension, in any case.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for others, with a list of those that are known.
    ///
    /// ```
    /// use octruss_meshio::Format;
    /// use std::path::Path;
    /// assert_eq!(Format::of(Path::new("a/part.VTU")).unwrap(), Format::Vtu);
    /// assert!(Format::of(Path::new("part.stl")).is_err());
    /// ```
    pub fn of(path: &Path) -> Result<Self, Error> {
        let extension = path.extension().map(|text| text.to_string_lossy().to_lowercase());
        let found = Self::ALL.into_iter().find(|f| extension.as_deref() == Some(f.extension()));
        found.ok_or_else(|| {
            let what =
                extension.map_or("no extension".into(), |text| format!("the extension .{text}"));
            Error::unsupported(
                path,
                format!(
                    "a file with {what} is of no known mesh format; {} can be read, {} written",
                    extensions(|_| true),
                    extensions(Self::writes)
                ),
            )
        })
    }

    /// What a file of this format cannot hold of `dataset`, a sentence each.
    pub fn losses(self, dataset: &Dataset) -> Vec<String> {
        match self {
            Self::Gmsh => Vec::new(),
            Self::Vtu => dataset.corner_losses().into_iter().collect(),
            Self::LegacyVtk => legacy::losses(dataset),
        }
    }

    /// Fails if `bytes` are empty or begin like a file of another format.
    pub(crate) fn check_content(self, bytes: &[u8]) -> Result<(), Problem> {
        if bytes.iter().all(u8::is_ascii_whitespace) {
            return Err(Problem::whole("the file is empty"));
        }
        let start = bytes.trim_ascii_start();
        let begins = |format: Self| {
            format.signatures().iter().any(|text| start.starts_with(text.as_bytes()))
        };
        let other = Self::ALL.into_iter().find(|&format| format != self && begins(format));
        other.map_or(Ok(()), |other| {
            Err(Problem::whole(format!(
                "the content is that of a .{} file; name it so",
                other.extension()
            )))
        })
    }
}

fn extensions(which: impl Fn(Format) -> bool) -> String {
    let names: Vec<String> = Format::ALL
        .into_iter()
        .filter(|&format| which(format))
        .map(|format| format!(".{}", format.extension()))
        .collect();
    names.join(", ")
}

/// Reads the mesh file at `path`, whose extension says its format.
///
/// # Errors
/// As of the format's own reader; [`Error::Unsupported`] if the extension is of none.
pub fn read(path: &Path) -> Result<Dataset, Error> {
    match Format::of(path)? {
        Format::Gmsh => gmsh::read(path),
        Format::Vtu => vtu::read(path),
        Format::LegacyVtk => legacy::read(path),
    }
}

/// The format in which [`write()`] will write a file at `path`, once that is
/// known to be possible: to be asked before long work.
///
/// # Errors
/// [`Error::Unsupported`] as of [`write()`]; [`Error::Io`] if the folder is
/// missing or not writable, or there is a folder at `path`.
pub fn check_target(path: &Path) -> Result<Format, Error> {
    let format = Format::of(path)?;
    if !format.writes() {
        return Err(not_written(path));
    }
    aside::check_place(path)?;
    Ok(format)
}

/// Writes `dataset` to `path`, whose extension says the format.
///
/// [`Format::losses`] tells what the format has no room for.
///
/// # Errors
/// As of the format's own writer; [`Error::Unsupported`] if the extension is of
/// none, or of one that is only read.
pub fn write(path: &Path, dataset: &Dataset) -> Result<(), Error> {
    match Format::of(path)? {
        Format::Gmsh => Err(not_written(path)),
        Format::Vtu => vtu::write(path, dataset),
        Format::LegacyVtk => legacy::write(path, dataset),
    }
}

fn not_written(path: &Path) -> Error {
    let formats = extensions(Format::writes);
    Error::unsupported(path, format!("Gmsh files are read, not written; {formats} can be written"))
}
