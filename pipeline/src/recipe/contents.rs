//! What a recipe holds.

use std::path::PathBuf;

use toml::Spanned;

use super::expect::Expectation;
use super::labels::labels;
use crate::error::Source;
use crate::options::Compare;
use crate::stages::Stage;

/// A named list of stages with expected numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Recipe {
    /// The name; the output folder is `out/NAME` unless another is given.
    pub name: String,
    /// The folder that input paths are relative to.
    pub folder: PathBuf,
    /// The text that the recipe was read from, for places in messages.
    pub source: Source,
    /// What to do, in order.
    pub stages: Vec<Stage>,
    /// What `octruss compare` varies; [`run`](crate::run()) does not look at it.
    pub compare: Option<Spanned<Compare>>,
    /// What the report must say, by name.
    pub expectations: Vec<Expectation>,
}

/// What each stage is called by overrides, reports and expectations: its kind,
/// from the second of a kind on with a number (`solve`, `solve-2`).
pub fn stage_labels(stages: &[Stage]) -> Vec<String> {
    labels(&stages.iter().map(Stage::kind).collect::<Vec<_>>())
}
