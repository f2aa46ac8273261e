//! A choice that may be left to the program.

use std::str::FromStr;

use serde::de::{Deserialize, Deserializer, Error};

use super::choice::{Choice, by_name, unknown};

/// A choice by its name, or none, which configs call `auto` or do not mention.
///
/// ```
/// use octruss::recipe::Auto;
/// use octruss::stages::Cycle;
/// assert_eq!("auto".parse(), Ok(Auto::<Cycle>(None)));
/// assert_eq!("w".parse(), Ok(Auto(Some(Cycle::W))));
/// let error = "x".parse::<Auto<Cycle>>().unwrap_err();
/// assert_eq!(error, "unknown cycle `x`; did you mean `v`? (valid: auto, v, w, full)");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Auto<T>(pub Option<T>);

/// What stands for no choice.
const AUTO: &str = "auto";

impl<T> Default for Auto<T> {
    fn default() -> Self {
        Self(None)
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

impl<'de, T: Choice> Deserialize<'de> for Auto<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}
