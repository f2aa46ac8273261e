//! Legacy VTK (`.vtk`), by way of vtkio, which knows its dialects.
//!
//! Unstructured grids are read, ASCII or binary, their cells and tags treated as
//! in [`crate::vtu`]. Malformed content is reported with the byte from which on the
//! file cannot be understood; other kinds of data and of cells are unsupported.
//!
//! The format has no room for group names, features, or anything that belongs
//! to the file as a whole and that vtkio could read back. Tags survive: tagged
//! triangles, edges and vertices are cells of their own behind the tets, and
//! the cell array `region` holds the tag of every cell.

mod dialect;
mod names;
mod read;
mod write;

pub use write::write;

use crate::format_spec::FormatSpec;
use crate::losses;

/// VTK's older format, `.vtk`: holds no group names, no features, and not which
/// fields are derived.
pub const FORMAT: FormatSpec = FormatSpec {
    name: "Legacy VTK",
    extension: "vtk",
    signatures: &["# vtk DataFile"],
    tells_strangers: false,
    read: read::parse,
    write: Some(write::write),
    losses: |dataset| {
        let losses = [
            losses::group_names("Legacy VTK", dataset),
            losses::features("Legacy VTK", dataset),
            losses::corner_fields("VTK", dataset),
            losses::derived_marks("Legacy VTK", dataset),
        ];
        losses.into_iter().flatten().collect()
    },
};
