//! Whether a mesh is fit for work: checks, their findings, and the quality of tets.

pub mod check;
pub mod finding;
pub mod hinges;
pub mod quality;
