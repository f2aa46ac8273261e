//! VTU, VTK's XML format for unstructured grids, read and written by ourselves.
//!
//! All encodings (ascii, base64 in line or appended, raw appended), both byte
//! orders and header types, and zlib compression are read; all number types are
//! widened. Pieces are joined. Tets become cells; triangles, lines and vertices
//! with a tag other than 0 become tagged simplices. Tags come from the first of
//! the cell arrays `region`, `gmsh:physical`, `medit:ref`, `CellEntityIds` and
//! `MaterialIds`. Quadratic simplices are read as their corners. What is left
//! out is said in [`crate::Dataset::notes`].
//!
//! Malformed content is reported with the line or array where the file breaks
//! its format; other cell types and compressors are unsupported.
//!
//! Reading goes from the outside in, each file one step:
//! `header` (XML: which arrays, where) → `decode` (the bytes of one: `base64`,
//! `blocks`) → `number` (bytes to numbers) → `read` (arrays to a grid).
//! Writing is `write`, `surfaces` and `features` (what the arrays are) and
//! `document` (XML and appended bytes).

mod array_tag;
mod attributes;
mod base64;
mod blocks;
mod decode;
mod document;
mod features;
mod header;
mod number;
mod own_points;
mod read;
mod surfaces;
mod write;

pub use document::{Compression, VtuOptions};
pub use features::write_features;
pub use surfaces::{surfaces_path, write_surfaces};
pub use write::{write, write_with};

use crate::format_spec::FormatSpec;
use crate::losses;

/// VTK's XML format for unstructured grids, `.vtu`: holds all of a dataset but
/// corner fields.
pub const FORMAT: FormatSpec = FormatSpec {
    name: "VTU",
    extension: "vtu",
    signatures: &["<VTKFile", "<?xml"],
    tells_strangers: false,
    read: read::parse,
    write: Some(write::write),
    losses: |dataset| losses::corner_fields("VTK", dataset).into_iter().collect(),
};
