//! Numbers that a config may give: checked when read.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use toml::Spanned;

/// A number; later also an expression, which today is refused by name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Value(pub f64);

/// One number for all regions, or one for each that is named.
#[derive(Debug, Clone, PartialEq)]
pub enum PerRegion {
    /// The same everywhere.
    Uniform(Value),
    /// By region name; [`PerRegion::DEFAULT`] is for those that are not named.
    Named(Vec<(Spanned<String>, Value)>),
}

/// A finite number above zero.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(try_from = "f64")]
pub struct Positive(pub f64);

/// An angle from 0 to 180 degrees.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(try_from = "f64")]
pub struct Degrees(pub f64);

/// A number from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(try_from = "f64")]
pub struct Fraction(pub f64);

impl TryFrom<f64> for Positive {
    type Error = String;

    fn try_from(number: f64) -> Result<Self, String> {
        let fits = number > 0.0 && number.is_finite();
        fits.then_some(Self(number)).ok_or(format!("expected a number above 0, found {number}"))
    }
}

impl TryFrom<f64> for Degrees {
    type Error = String;

    fn try_from(number: f64) -> Result<Self, String> {
        (0.0..=180.0)
            .contains(&number)
            .then_some(Self(number))
            .ok_or(format!("expected an angle from 0 to 180 degrees, found {number}"))
    }
}

impl TryFrom<f64> for Fraction {
    type Error = String;

    fn try_from(number: f64) -> Result<Self, String> {
        (0.0..=1.0)
            .contains(&number)
            .then_some(Self(number))
            .ok_or(format!("expected a number from 0 to 1, found {number}"))
    }
}

impl PerRegion {
    /// The name that stands for all regions that are not named.
    pub const DEFAULT: &'static str = "default";
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueVisitor)
    }
}

struct ValueVisitor;

impl Visitor<'_> for ValueVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Value, E> {
        if !number.is_finite() {
            return Err(E::custom(format!("expected a finite number, found {number}")));
        }
        Ok(Value(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Value, E> {
        Ok(Value(number as f64))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Value, E> {
        Err(E::custom(format!(
            "found the string \"{text}\": expressions are not supported, give a number"
        )))
    }
}

impl<'de> Deserialize<'de> for PerRegion {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PerRegionVisitor)
    }
}

struct PerRegionVisitor;

impl<'de> Visitor<'de> for PerRegionVisitor {
    type Value = PerRegion;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or a table of numbers by region name")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<PerRegion, E> {
        ValueVisitor.visit_f64(number).map(PerRegion::Uniform)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<PerRegion, E> {
        ValueVisitor.visit_i64(number).map(PerRegion::Uniform)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<PerRegion, E> {
        ValueVisitor.visit_str(text).map(PerRegion::Uniform)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<PerRegion, A::Error> {
        let mut named = Vec::new();
        while let Some(entry) = map.next_entry()? {
            named.push(entry);
        }
        Ok(PerRegion::Named(named))
    }
}
