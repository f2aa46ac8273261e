//! The stage that refines.

mod features;
mod keys;
mod stage;
mod step;

pub use keys::Subdivide;
