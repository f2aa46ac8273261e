//! A mesh in numbers, sound or not.

mod description;
mod measure;

pub use description::{Description, FieldReport, Quality, Region, Surface};
pub use measure::describe;
