//! Mesh files to [`Dataset`]s and back, one file a format.

pub mod dataset;

pub use dataset::{Dataset, Field, Values};
