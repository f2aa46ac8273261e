//! VTU, VTK's XML format for unstructured grids, read and written by ourselves.
//!
//! Reading goes from the outside in, each file one step:
//! `header` (XML: which arrays, where) → `decode` (the bytes of one: `base64`,
//! `blocks`) → `number` (bytes to numbers) → `read` (arrays to a grid).
//! Writing is `write`, `surfaces` and `features` (what the arrays are) and
//! `document` (XML and appended bytes).

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
pub use read::read;
pub use surfaces::{surfaces_path, write_surfaces};
pub use write::{write, write_with};
