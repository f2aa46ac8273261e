//! Mesh files to [`Dataset`]s and back, one file a format.

pub mod dataset;
pub mod error;
pub mod gmsh;

pub use dataset::{Dataset, Field, Values};
pub use error::{Error, Place};
