//! The smooth surfaces and curves that subdivision tends to.

mod across;
mod controls;
pub mod corner;
pub mod curve;
mod descent;
pub mod distances;
mod error;
mod fan;
pub mod point;
pub mod positions;
mod ring;
mod sectors;
mod side;
mod spline_patch;
pub mod surface;
mod walk;

pub use error::LimitError;
