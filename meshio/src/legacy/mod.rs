//! Legacy VTK (`.vtk`), by way of vtkio, which knows its dialects.
//!
//! The format has no room for group names, features, or anything that belongs
//! to the file as a whole and that vtkio could read back. Tags survive: tagged
//! triangles, edges and vertices are cells of their own behind the tets, and
//! the cell array `region` holds the tag of every cell.

mod dialect;
mod names;
mod read;
mod write;

pub use read::read;
pub(crate) use write::losses;
pub use write::write;
