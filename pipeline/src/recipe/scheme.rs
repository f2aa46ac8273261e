//! Subdivision schemes by name.

use std::str::FromStr;

use octruss_mesh::Scheme;
use serde::de::{Deserialize, Deserializer, Error};

use super::nearest::suggestion;

/// A [`Scheme`] that configs and the command line call by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SchemeName(pub Scheme);

impl SchemeName {
    /// Every scheme, by name.
    pub const VALID: [&'static str; 2] = ["linear", "box-spline"];
}

impl FromStr for SchemeName {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        [Scheme::Linear, Scheme::BoxSpline]
            .into_iter()
            .find(|scheme| scheme.name() == name)
            .map(Self)
            .ok_or_else(|| format!("unknown scheme `{name}`{}", suggestion(name, &Self::VALID)))
    }
}

impl<'de> Deserialize<'de> for SchemeName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_valid_name_is_a_scheme() {
        for name in SchemeName::VALID {
            assert_eq!(name.parse::<SchemeName>().unwrap().0.name(), name);
        }
    }
}
