//! How a problem is solved: all that can be chosen, each choice in one place.

pub mod choices;
pub mod prolongations;
pub mod solving;
pub mod sweeps;
