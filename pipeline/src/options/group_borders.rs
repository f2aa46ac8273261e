//! Which borders between surface groups stay sharp.

use std::fmt;
use std::str::FromStr;

use octruss_base::choice::Named;
use octruss_mesh::GroupBorders;
use serde::de::{Deserialize, Deserializer, Error, Visitor};

/// The choice by its name, or `true` for all borders and `false` for none.
///
/// ```
/// use octruss::options::GroupBordersKey;
/// use octruss_mesh::GroupBorders;
/// assert_eq!("flat".parse(), Ok(GroupBordersKey(GroupBorders::Flat)));
/// assert_eq!("true".parse(), Ok(GroupBordersKey(GroupBorders::All)));
/// assert!("some".parse::<GroupBordersKey>().is_err());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupBordersKey(pub GroupBorders);

impl From<bool> for GroupBordersKey {
    fn from(kept: bool) -> Self {
        Self(if kept { GroupBorders::All } else { GroupBorders::None })
    }
}

impl FromStr for GroupBordersKey {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse::<bool>() {
            Ok(kept) => Ok(kept.into()),
            Err(_) => text.parse().map(|Named(choice)| Self(choice)),
        }
    }
}

impl<'de> Deserialize<'de> for GroupBordersKey {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(GroupBordersVisitor)
    }
}

struct GroupBordersVisitor;

impl Visitor<'_> for GroupBordersVisitor {
    type Value = GroupBordersKey;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"flat\", \"all\" or true, \"none\" or false")
    }

    fn visit_bool<E: Error>(self, kept: bool) -> Result<GroupBordersKey, E> {
        Ok(kept.into())
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<GroupBordersKey, E> {
        name.parse().map_err(E::custom)
    }
}
