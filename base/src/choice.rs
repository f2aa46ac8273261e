//! Closed choices, which configs and the command line make by name.

use crate::suggestion::suggestion;
use serde::de::{Deserialize, Deserializer, Error};
use std::str::FromStr;

/// What can be chosen by name; implemented by the crate that owns the choice.
pub trait Choice: Copy + 'static {
    /// What is chosen, in a word.
    const WHAT: &'static str;
    /// All that there is.
    const ALL: &'static [Self];
    /// The name of one.
    fn name(self) -> &'static str;
}

/// A choice by its name.
///
/// ```
/// use octruss_base::choice::{Choice, Named};
///
/// #[derive(Debug, Clone, Copy, PartialEq)]
/// enum Colour {
///     Red,
///     Green,
/// }
///
/// impl Choice for Colour {
///     const WHAT: &'static str = "colour";
///     const ALL: &'static [Self] = &[Self::Red, Self::Green];
///     fn name(self) -> &'static str {
///         match self {
///             Self::Red => "red",
///             Self::Green => "green",
///         }
///     }
/// }
///
/// assert_eq!("green".parse(), Ok(Named(Colour::Green)));
/// let error = "rod".parse::<Named<Colour>>().unwrap_err();
/// assert_eq!(error, "unknown colour `rod`; did you mean `red`? (valid: red, green)");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Named<T>(pub T);

/// A choice by its name, or none, which is called `auto`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Auto<T>(pub Option<T>);

/// What stands for no choice.
const AUTO: &str = "auto";

impl<T> Default for Auto<T> {
    fn default() -> Self {
        Self(None)
    }
}

impl<T: Choice> FromStr for Named<T> {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        by_name(name).map(Self).ok_or_else(|| unknown::<T>(name, &[]))
    }
}

impl<T: Choice> FromStr for Auto<T> {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        match by_name(name) {
            None if name != AUTO => Err(unknown::<T>(name, &[AUTO])),
            choice => Ok(Self(choice)),
        }
    }
}

/// The choice of this name, if there is one.
fn by_name<T: Choice>(name: &str) -> Option<T> {
    T::ALL.iter().copied().find(|choice| choice.name() == name)
}

/// The message about a name that is none, where `others` are valid, too.
fn unknown<T: Choice>(name: &str, others: &[&str]) -> String {
    let names = T::ALL.iter().map(|choice| choice.name());
    let valid: Vec<&str> = others.iter().copied().chain(names).collect();
    format!("unknown {} `{name}`{}", T::WHAT, suggestion(name, &valid))
}

impl<'de, T: Choice> Deserialize<'de> for Named<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}

impl<'de, T: Choice> Deserialize<'de> for Auto<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}

/// Reads a field that holds a choice, by its name.
///
/// # Errors
/// A name that is none, with the nearest one.
pub fn named<'de, T: Choice, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    Named::deserialize(deserializer).map(|Named(choice)| choice)
}

/// Reads a field that holds a choice or none, by its name or `auto`.
///
/// # Errors
/// As [`named`].
pub fn auto<'de, T: Choice, D: Deserializer<'de>>(deserializer: D) -> Result<Option<T>, D::Error> {
    Auto::deserialize(deserializer).map(|Auto(choice)| choice)
}
