//! Closed choices of the mesh crate, by name.

use std::str::FromStr;

use octruss_mesh::{AffineCorrection, Diagonal, InterfaceRows, Marking, Scheme};
use serde::de::{Deserialize, Deserializer, Error};

use super::nearest::suggestion;

/// A choice that configs and the command line make by its name.
///
/// ```
/// use octruss::recipe::{Named, SchemeName};
/// assert_eq!("box-spline".parse(), Ok(Named(octruss_mesh::Scheme::BoxSpline)));
/// let error = "lineer".parse::<SchemeName>().unwrap_err();
/// assert!(error.starts_with("unknown scheme `lineer`; did you mean `linear`? (valid: linear, "));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Named<T>(pub T);

/// A scheme with its usual parameters.
pub type SchemeName = Named<Scheme>;

/// What can be chosen by name.
pub trait Choice: Copy + 'static {
    /// What is chosen, in a word.
    const WHAT: &'static str;
    /// All that there is.
    const ALL: &'static [Self];
    /// The name of one.
    fn name(self) -> &'static str;
}

/// The mesh crate names its choices itself.
macro_rules! choices_of_the_mesh {
    ($($choice:ident: $what:literal,)*) => {$(
        impl Choice for $choice {
            const WHAT: &'static str = $what;
            const ALL: &'static [Self] = &$choice::ALL;
            fn name(self) -> &'static str {
                $choice::name(self)
            }
        }
    )*};
}

choices_of_the_mesh! {
    Scheme: "scheme",
    Marking: "marking",
    Diagonal: "diagonal",
    AffineCorrection: "affine correction",
    InterfaceRows: "choice of interface rows",
}

impl<T: Choice> FromStr for Named<T> {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        by_name(name).map(Self).ok_or_else(|| unknown::<T>(name, &[]))
    }
}

/// The choice of this name, if there is one.
pub(super) fn by_name<T: Choice>(name: &str) -> Option<T> {
    T::ALL.iter().copied().find(|choice| choice.name() == name)
}

/// The message about a name that is none, where `others` are valid, too.
pub(super) fn unknown<T: Choice>(name: &str, others: &[&str]) -> String {
    let names = T::ALL.iter().map(|choice| choice.name());
    let valid: Vec<&str> = others.iter().copied().chain(names).collect();
    format!("unknown {} `{name}`{}", T::WHAT, suggestion(name, &valid))
}

impl<'de, T: Choice> Deserialize<'de> for Named<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}
