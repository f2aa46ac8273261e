//! A recipe: a named list of stages with the numbers expected of them.
//!
//! ```text
//! config file ─▶ Source ─▶ tree of values ─▶ overrides ─▶ serde ─▶ Recipe
//! ```
//!
//! Every value keeps its place in the text up to the end, so that each error
//! points at a file, a line and a key.

mod contents;
mod expect;
mod explain;
mod labels;
mod overrides;
mod parse;
mod solve_keys;
mod stage_tables;
mod tree;

pub use contents::{Recipe, stage_labels};
pub use expect::{Expectation, compare};
