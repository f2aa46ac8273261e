//! The smooth surfaces and curves that subdivision tends to.

mod controls;
pub mod corner;
pub mod curve;
mod descent;
mod error;
mod fan;
pub mod point;
mod ring;
mod sectors;
mod side;
mod spline_patch;
pub mod surface;
mod walk;

pub use error::LimitError;
