//! Mesh files to [`Dataset`]s and back, one module a format.
//!
//! [`read`] and [`write()`] choose the [`Format`] by the file's extension:
//!
//! ```
//! use octruss_meshio::{Dataset, read, write};
//!
//! let mesh = octruss_mesh::shapes::five_tet_cube().into_raw();
//! let cube = Dataset { mesh, ..Dataset::default() };
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("cube.vtu");
//! write(&path, &cube).unwrap();
//! assert_eq!(read(&path).unwrap(), cube);
//! ```

pub mod aside;
pub mod dataset;
pub mod error;
pub mod format;
pub mod format_spec;
pub mod gmsh;
pub mod legacy;
pub mod medit;
pub mod pvd;
pub mod vtu;

mod cell_kind;
mod field_data;
mod fingerprint;
mod grid;
mod losses;
mod mid_side;
mod notes;
mod problem;
mod text;

pub use aside::write_aside;
pub use dataset::{Dataset, Field, Values};
pub use error::{Error, Place};
pub use format::{Format, check_target, parse, read, write};
pub use format_spec::FormatSpec;
