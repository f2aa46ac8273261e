//! The smooth surfaces and curves that subdivision tends to.

mod across;
mod controls;
pub mod corner;
pub mod curve;
pub mod distances;
mod error;
mod fan;
mod patches;
pub mod point;
pub mod positions;
mod sectors;
mod side;
pub mod surface;
mod walk;

pub use error::LimitError;
