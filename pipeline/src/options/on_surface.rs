//! What acts on a named surface, as configs give it.

use serde::Deserialize;
use toml::Spanned;

use crate::options::{Value, ValueOrVector, VectorValue};

/// A number or expression on a named surface.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct OnSurface {
    /// The surface group.
    pub surface: Spanned<String>,
    /// The value there.
    pub value: Value,
}

/// A vector on a named surface.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct VectorOnSurface {
    /// The surface group.
    pub surface: Spanned<String>,
    /// The vector there.
    pub value: VectorValue,
}

/// Exchange with a surrounding on a named surface.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct RobinOnSurface {
    /// The surface group.
    pub surface: Spanned<String>,
    /// At least 0, per unit of area.
    pub coefficient: Value,
    /// The value of the surrounding.
    pub value: Value,
}

/// An elastic foundation of a named surface.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Springs {
    /// The surface group.
    pub surface: Spanned<String>,
    /// One value along the normal alone, or three along the axes.
    pub stiffness: ValueOrVector,
}
