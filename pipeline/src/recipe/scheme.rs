//! Subdivision schemes by name.

use std::str::FromStr;

use octruss_mesh::Scheme;
use serde::de::{Deserialize, Deserializer, Error};

use super::nearest::suggestion;

/// A [`Scheme`] that configs and the command line call by its name.
///
/// ```
/// use octruss::recipe::SchemeName;
/// assert_eq!("box-spline".parse(), Ok(SchemeName(octruss_mesh::Scheme::BoxSpline)));
/// let error = "lineer".parse::<SchemeName>().unwrap_err();
/// assert!(error.starts_with("unknown scheme `lineer`; did you mean `linear`? (valid: linear, "));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SchemeName(pub Scheme);

impl FromStr for SchemeName {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        Scheme::from_name(name).map(Self).ok_or_else(|| {
            let valid = Scheme::ALL.map(Scheme::name);
            format!("unknown scheme `{name}`{}", suggestion(name, &valid))
        })
    }
}

impl<'de> Deserialize<'de> for SchemeName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}
