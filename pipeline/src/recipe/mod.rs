//! A recipe: a named list of stages with the numbers expected of them.
//!
//! ```text
//! config file ─▶ Source ─▶ tree of values ─▶ overrides ─▶ serde ─▶ Recipe
//! ```
//!
//! Every value keeps its place in the text up to the end, so that each error
//! points at a file, a line and a key.

mod expect;
mod explain;
mod labels;
mod overrides;
mod parse;
mod solve_keys;
mod tree;

use std::path::{Path, PathBuf};

use toml::Spanned;

pub use expect::{Expectation, compare};

use crate::error::{ConfigError, Place, Source};
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

impl Recipe {
    /// Reads a config file and puts overrides (`key=value`, see the
    /// [command line](crate#configs)) into it.
    ///
    /// # Errors
    /// A file that cannot be read; anything in it that is no recipe, with file,
    /// line, column and key.
    pub fn load(path: &Path, overrides: &[String]) -> Result<Self, ConfigError> {
        let text = std::fs::read_to_string(path).map_err(|error| ConfigError {
            place: Place::File(path.into()),
            message: format!("cannot read the config: {error}"),
        })?;
        Self::parse(path, text, overrides)
    }

    /// Reads a config from its text; `path` is for messages and relative paths.
    ///
    /// # Errors
    /// As [`Recipe::load`].
    ///
    /// ```
    /// use octruss::recipe::Recipe;
    /// let text = "name = \"cube\"\n[[stage]]\nkind = \"import\"\npth = \"cube.msh\"\n";
    /// let error = Recipe::parse("cube.toml".as_ref(), text.into(), &[]).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "cube.toml:4:1: unknown key `pth` in stage `import`; \
    ///      did you mean `path`? (valid: path)"
    /// );
    /// ```
    pub fn parse(path: &Path, text: String, overrides: &[String]) -> Result<Self, ConfigError> {
        parse::parse(path, text, overrides)
    }
}

/// What each stage is called by overrides, reports and expectations: its kind,
/// from the second of a kind on with a number (`solve`, `solve-2`).
pub fn stage_labels(stages: &[Stage]) -> Vec<String> {
    labels::labels(&stages.iter().map(Stage::kind).collect::<Vec<_>>())
}
