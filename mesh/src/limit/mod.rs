//! The smooth surfaces and curves that subdivision tends to.

mod across;
pub mod corner;
pub mod curve;
pub mod distances;
mod error;
mod fan;
pub mod point;
pub mod positions;
mod ring;
mod ring_step;
mod sectors;
mod spline_patch;
pub mod surface;

pub use error::LimitError;
