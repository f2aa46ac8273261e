//! One value for all regions, or one for each that is named.

use std::fmt;
use std::marker::PhantomData;

use serde::de::value::SeqAccessDeserializer;
use serde::de::{
    Deserialize, Deserializer, Error, IntoDeserializer, MapAccess, SeqAccess, Visitor,
};
use toml::Spanned;

use super::value::{Value, VectorValue};

/// One value for all regions, or one for each that is named.
#[derive(Debug, Clone, PartialEq)]
pub enum PerRegion<T = Value> {
    /// The same everywhere.
    Uniform(T),
    /// By region name; [`PerRegion::DEFAULT`] is for those that are not named.
    Named(Vec<(Spanned<String>, T)>),
}

impl<T> PerRegion<T> {
    /// The name that stands for all regions that are not named.
    pub const DEFAULT: &'static str = "default";
}

/// What may be given by region.
pub trait Regional: Sized {
    /// What it looks like, for one region.
    const WHAT: &'static str;
    /// What is read from each entry of a table, before it is known whether the
    /// table is one of regions.
    type Entry: for<'de> Deserialize<'de>;
    /// A whole table.
    ///
    /// # Errors
    /// What is wrong with it.
    fn from_table(table: Vec<(Spanned<String>, Self::Entry)>) -> Result<PerRegion<Self>, String>;
}

impl Regional for Value {
    const WHAT: &'static str = "a number or an expression in x, y and z";
    type Entry = Self;
    fn from_table(table: Vec<(Spanned<String>, Self)>) -> Result<PerRegion<Self>, String> {
        Ok(PerRegion::Named(table))
    }
}

impl Regional for VectorValue {
    const WHAT: &'static str = "a list of three numbers or expressions";
    type Entry = Self;
    fn from_table(table: Vec<(Spanned<String>, Self)>) -> Result<PerRegion<Self>, String> {
        Ok(PerRegion::Named(table))
    }
}

impl<'de, T: Regional + Deserialize<'de>> Deserialize<'de> for PerRegion<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PerRegionVisitor(PhantomData))
    }
}

struct PerRegionVisitor<T>(PhantomData<T>);

impl<'de, T: Regional + Deserialize<'de>> Visitor<'de> for PerRegionVisitor<T> {
    type Value = PerRegion<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, or a table of such by region name", T::WHAT)
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<PerRegion<T>, E> {
        T::deserialize(number.into_deserializer()).map(PerRegion::Uniform)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<PerRegion<T>, E> {
        T::deserialize(number.into_deserializer()).map(PerRegion::Uniform)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<PerRegion<T>, E> {
        T::deserialize(text.into_deserializer()).map(PerRegion::Uniform)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<PerRegion<T>, A::Error> {
        T::deserialize(SeqAccessDeserializer::new(list)).map(PerRegion::Uniform)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<PerRegion<T>, A::Error> {
        let mut table = Vec::new();
        while let Some(entry) = map.next_entry()? {
            table.push(entry);
        }
        T::from_table(table).map_err(A::Error::custom)
    }
}
