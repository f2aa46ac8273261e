//! Which file is which: formats by extension, and what each can do.

use std::path::Path;

use crate::dataset::Dataset;
use crate::error::Error;
use crate::format_spec::FormatSpec;
use crate::problem::Problem;
use crate::{aside, gmsh, legacy, medit, vtu};

/// One of the mesh formats.
///
/// It equals the constant that describes it:
///
/// ```
/// use octruss_meshio::{Format, vtu};
/// use std::path::Path;
/// assert!(Format::of(Path::new("part.vtu")).unwrap() == vtu::FORMAT);
/// ```
#[derive(Clone, Copy)]
pub struct Format(&'static FormatSpec);

impl Format {
    /// All formats. A new one is entered here, and nowhere else.
    pub const ALL: &[Self] =
        &[Self(&gmsh::FORMAT), Self(&vtu::FORMAT), Self(&legacy::FORMAT), Self(&medit::FORMAT)];

    /// What its files are called, as in "Gmsh files".
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// The extension of its files, without a dot.
    pub fn extension(self) -> &'static str {
        self.0.extension
    }

    /// Whether [`write()`] can write it; [`read`] reads all formats.
    pub fn writes(self) -> bool {
        self.0.write.is_some()
    }

    /// The format of a file by its extension, in any case.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for others, with a list of those that are known.
    ///
    /// ```
    /// use octruss_meshio::Format;
    /// use std::path::Path;
    /// assert_eq!(Format::of(Path::new("a/part.VTU")).unwrap().extension(), "vtu");
    /// assert!(Format::of(Path::new("part.stl")).is_err());
    /// ```
    pub fn of(path: &Path) -> Result<Self, Error> {
        let extension = path.extension().map(|text| text.to_string_lossy().to_lowercase());
        let found = Self::ALL.iter().find(|f| extension.as_deref() == Some(f.extension()));
        found.copied().ok_or_else(|| {
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
        (self.0.losses)(dataset)
    }

    /// The dataset in the bytes of a file of this format.
    fn parse(self, bytes: &[u8]) -> Result<Dataset, Problem> {
        if !self.0.tells_strangers {
            self.refuse_strangers(bytes)?;
        }
        (self.0.read)(bytes)
    }

    /// Fails if `bytes` are empty or begin like a file of another format.
    fn refuse_strangers(self, bytes: &[u8]) -> Result<(), Problem> {
        if bytes.iter().all(u8::is_ascii_whitespace) {
            return Err(Problem::whole("the file is empty"));
        }
        let start = bytes.trim_ascii_start();
        let begins = |format: &Self| {
            format.0.signatures.iter().any(|text| start.starts_with(text.as_bytes()))
        };
        let other = Self::ALL.iter().find(|&format| *format != self && begins(format));
        other.map_or(Ok(()), |other| {
            Err(Problem::whole(format!(
                "the content is that of a .{} file; name it so",
                other.extension()
            )))
        })
    }
}

impl PartialEq for Format {
    fn eq(&self, other: &Self) -> bool {
        *self == *other.0
    }
}

impl Eq for Format {}

impl PartialEq<FormatSpec> for Format {
    fn eq(&self, other: &FormatSpec) -> bool {
        self.0.extension == other.extension
    }
}

impl std::fmt::Debug for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Format({})", self.name())
    }
}

/// The extensions of some formats, as a message lists them.
fn extensions(which: impl Fn(Format) -> bool) -> String {
    let listed = Format::ALL.iter().filter(|&&format| which(format));
    listed.map(|format| format!(".{}", format.extension())).collect::<Vec<_>>().join(", ")
}

/// Reads the mesh file at `path`, whose extension says its format.
///
/// What a format's reader keeps, and what it leaves out, is told in the module
/// of the format.
///
/// # Errors
/// [`Error::Io`] if the file cannot be read; [`Error::Malformed`], with the place,
/// if it is not what its format prescribes; [`Error::Unsupported`] if it holds
/// what is not handled, or its extension is of no format.
pub fn read(path: &Path) -> Result<Dataset, Error> {
    // A name that says nothing is refused before the file is opened.
    Format::of(path)?;
    let bytes = std::fs::read(path).map_err(|source| Error::io(path, source))?;
    parse(path, &bytes)
}

/// Reads the content of a mesh file like [`read`]; `path` says the format and
/// serves the messages, the file need not exist.
///
/// # Errors
/// As of [`read`].
///
/// ```
/// let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
///     $Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n\
///     $Elements\n1\n1 4 2 7 1 1 2 3 4\n$EndElements\n";
/// let dataset = octruss_meshio::parse("tet.msh".as_ref(), text.as_bytes())?;
/// assert_eq!(dataset.mesh.tets, [[0, 1, 2, 3]]);
/// assert_eq!(dataset.mesh.regions, [7]);
/// # Ok::<(), octruss_meshio::Error>(())
/// ```
pub fn parse(path: &Path, bytes: &[u8]) -> Result<Dataset, Error> {
    Format::of(path)?.parse(bytes).map_err(|problem| problem.of(path))
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
        return Err(not_written(path, format));
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
    let format = Format::of(path)?;
    let write = format.0.write.ok_or_else(|| not_written(path, format))?;
    write(path, dataset)
}

fn not_written(path: &Path, format: Format) -> Error {
    let (name, others) = (format.name(), extensions(Format::writes));
    Error::unsupported(path, format!("{name} files are read, not written; {others} can be written"))
}
