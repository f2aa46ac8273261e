//! The bytes of a VTU file: XML, then every array raw in one appended section.

use std::borrow::Cow;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use bytemuck::cast_slice;

use super::blocks;
use super::number::NumberType;
use crate::aside::write_aside;
use crate::dataset::{Field, Values};
use crate::error::Error;
use crate::field_data::{PREFIX, SideArray, SideContent};

/// How a VTU file is written; all choices hold the same values.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct VtuOptions {
    /// How its arrays are compressed.
    pub compression: Compression,
}

/// How arrays are compressed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Compression {
    /// Not at all: quickest to write and read.
    #[default]
    None,
    /// By zlib at a level from 1 (quick) to 9 (small); higher ones count as 9.
    Zlib(u32),
}

/// One array of a file, its bytes as they are in memory.
pub(crate) struct Array<'a> {
    pub(crate) name: Cow<'a, str>,
    pub(crate) kind: NumberType,
    pub(crate) components: usize,
    pub(crate) tuples: usize,
    pub(crate) bytes: Cow<'a, [u8]>,
}

/// What a file holds.
pub(crate) struct Document<'a> {
    pub(crate) points: usize,
    pub(crate) cells: usize,
    pub(crate) field_data: Vec<Array<'a>>,
    pub(crate) point_data: Vec<Array<'a>>,
    pub(crate) cell_data: Vec<Array<'a>>,
    pub(crate) positions: Vec<Array<'a>>,
    pub(crate) topology: Vec<Array<'a>>,
}

impl<'a> Array<'a> {
    /// An array of numbers.
    pub(crate) fn numbers<T: bytemuck::NoUninit>(
        name: impl Into<Cow<'a, str>>,
        kind: NumberType,
        components: usize,
        values: impl Into<Cow<'a, [T]>>,
    ) -> Self {
        let bytes = match values.into() {
            Cow::Borrowed(values) => Cow::Borrowed(cast_slice(values)),
            Cow::Owned(values) => Cow::Owned(cast_slice(&values).to_vec()),
        };
        let tuples = bytes.len() / kind.width() / components;
        Self { name: name.into(), kind, components, tuples, bytes }
    }

    /// The array of a field.
    pub(crate) fn field(field: &'a Field) -> Self {
        let name = field.name.as_str();
        match &field.values {
            Values::Float(v) => {
                Self::numbers(name, NumberType::Float64, field.components, v.as_slice())
            }
            Values::Integer(v) => {
                Self::numbers(name, NumberType::Int64, field.components, v.as_slice())
            }
        }
    }

    /// An array of the file as a whole.
    pub(crate) fn side(array: SideArray<'a>) -> Self {
        let name = format!("{PREFIX}{}", array.name);
        match array.content {
            SideContent::Vertices(v) => {
                Self::numbers(name, NumberType::UInt32, array.components, v)
            }
            SideContent::Ids(ids) => Self::numbers(name, NumberType::Int32, array.components, ids),
            SideContent::Bytes(bytes) => Self::numbers(name, NumberType::UInt8, 1, bytes),
        }
    }
}

impl Document<'_> {
    /// Writes the file at `path`, whole or not at all.
    pub(crate) fn write(&self, path: &Path, options: &VtuOptions) -> Result<(), Error> {
        let mut xml = Xml { text: String::new(), offset: 0, blobs: Vec::new(), options };
        self.describe(&mut xml).map_err(|message| Error::unsupported(path, message))?;
        write_aside(path, |file| {
            file.write_all(xml.text.as_bytes())?;
            for blob in &xml.blobs {
                match blob {
                    Blob::Plain(bytes) => {
                        file.write_all(&(bytes.len() as u64).to_ne_bytes())?;
                        file.write_all(bytes)?;
                    }
                    Blob::Compressed(bytes) => file.write_all(bytes)?,
                }
            }
            file.write_all(b"\n  </AppendedData>\n</VTKFile>\n")
        })
    }

    fn describe<'s>(&'s self, xml: &mut Xml<'s>) -> Result<(), String> {
        let order = if cfg!(target_endian = "big") { "BigEndian" } else { "LittleEndian" };
        let compressor = match xml.options.compression {
            Compression::None => "",
            Compression::Zlib(_) => " compressor=\"vtkZLibDataCompressor\"",
        };
        xml.line(&format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
             byte_order=\"{order}\" header_type=\"UInt64\"{compressor}>\n  <UnstructuredGrid>"
        ));
        xml.list("FieldData", &self.field_data, true)?;
        let (points, cells) = (self.points, self.cells);
        xml.line(&format!("    <Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"));
        xml.list("PointData", &self.point_data, false)?;
        xml.list("CellData", &self.cell_data, false)?;
        xml.list("Points", &self.positions, false)?;
        xml.list("Cells", &self.topology, false)?;
        xml.line("    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">");
        xml.text.push('_');
        Ok(())
    }
}

enum Blob<'a> {
    Plain(&'a [u8]),
    Compressed(Vec<u8>),
}

/// The XML as far as it is written, and the arrays that it announces so far.
struct Xml<'a> {
    text: String,
    offset: usize,
    blobs: Vec<Blob<'a>>,
    options: &'a VtuOptions,
}

impl<'a> Xml<'a> {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// One element with arrays in it; those of the file as a whole say how long they are.
    fn list(&mut self, element: &str, arrays: &'a [Array<'a>], whole: bool) -> Result<(), String> {
        self.line(&format!("    <{element}>"));
        for array in arrays {
            // Writing to a String cannot fail.
            let mut line = String::from("      <DataArray");
            let _ = write!(line, " type=\"{}\"", array.kind.name());
            let _ = write!(line, " Name=\"{}\"", escape(&array.name)?);
            let _ = write!(line, " NumberOfComponents=\"{}\"", array.components);
            if whole {
                let _ = write!(line, " NumberOfTuples=\"{}\"", array.tuples);
            }
            let _ = write!(line, " format=\"appended\" offset=\"{}\"/>", self.offset);
            self.line(&line);
            self.append(&array.bytes)?;
        }
        self.line(&format!("    </{element}>"));
        Ok(())
    }

    fn append(&mut self, bytes: &'a [u8]) -> Result<(), String> {
        match self.options.compression {
            Compression::None => {
                self.offset += size_of::<u64>() + bytes.len();
                self.blobs.push(Blob::Plain(bytes));
            }
            Compression::Zlib(level) => {
                let packed = blocks::compress(bytes, level.clamp(1, 9))
                    .map_err(|reason| format!("zlib refused to compress: {reason}"))?;
                self.offset += packed.len();
                self.blobs.push(Blob::Compressed(packed));
            }
        }
        Ok(())
    }
}

/// A name as the value of an XML attribute. The error is one that XML cannot hold.
fn escape(name: &str) -> Result<String, String> {
    let mut escaped = String::with_capacity(name.len());
    for character in name.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\t' | '\n' | '\r' => {
                let _ = write!(escaped, "&#{};", u32::from(character));
            }
            '\0'..' ' | '\u{fffe}' | '\u{ffff}' => {
                return Err(format!(
                    "the name {name:?} holds a control character, which XML cannot; rename it"
                ));
            }
            other => escaped.push(other),
        }
    }
    Ok(escaped)
}
