//! From the text of a config to a recipe.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde::de::IgnoredAny;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::contents::Recipe;
use super::expect::Expectation;
use super::explain::deserialize;
use super::overrides::apply;
use super::stage_tables::read_stages;
use super::tree::Tree;
use crate::error::{ConfigError, ConfigPlace, Source};
use crate::options::Compare;
use crate::report::Bounds;

/// All of a config but its stages.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Header {
    name: Spanned<String>,
    #[serde(rename = "stage", default)]
    _stages: IgnoredAny,
    #[serde(default)]
    compare: Option<Spanned<Compare>>,
    #[serde(default)]
    expect: BTreeMap<Spanned<String>, Bounds>,
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
            place: ConfigPlace::File(path.into()),
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
        let source = Source::new(path.into(), text, overrides);
        let document = DeTable::parse(source.text()).map_err(|error| {
            source.error(&error.span().unwrap_or(0..0), error.message().trim_end())
        })?;
        let mut root = Spanned::new(document.span(), DeValue::Table(document.into_inner()));
        for given in source.overrides() {
            apply(&mut root, given, &source)?;
        }
        let header = read_header(&root, &source)?;
        let stages = read_stages(&root, &source)?;
        let expectations = header.expect.into_iter().map(|(name, bounds)| Expectation {
            place: source.place(&name.span()),
            name: name.into_inner(),
            bounds,
        });
        let expectations = expectations.collect();
        let (name, folder) =
            (header.name.into_inner(), path.parent().unwrap_or(Path::new("")).into());
        let compare = header.compare;
        Ok(Recipe { name, folder, stages, compare, expectations, source })
    }
}

fn read_header(root: &Tree, source: &Source) -> Result<Header, ConfigError> {
    let header: Header = deserialize(root.clone(), None, source)?;
    let name = header.name.get_ref();
    if name.is_empty() || name.starts_with('.') || name.contains(['/', '\\']) {
        let message = format!("`name` is \"{name}\", but it must do as the name of a folder");
        return Err(source.error(&header.name.span(), message));
    }
    Ok(header)
}
