//! A config before it is read: values with their places.

use toml::Spanned;
use toml::de::DeValue;

/// A value of a config with its place.
pub type Tree<'a> = Spanned<DeValue<'a>>;
