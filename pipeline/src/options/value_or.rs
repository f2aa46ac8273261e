//! One value, or something larger in its place.

use std::fmt;
use std::marker::PhantomData;

use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::per_region::Regional;
use super::value::{Value, ValueVisitor, VectorValue};

/// One value, or a list or table.
#[derive(Debug, Clone, PartialEq)]
pub enum ValueOr<T> {
    /// A number or an expression.
    One(Value),
    /// A list or a table.
    Other(T),
}

/// One value or a vector.
pub type ValueOrVector = ValueOr<VectorValue>;

impl<'de, T: Regional + Deserialize<'de>> Deserialize<'de> for ValueOr<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueOrVisitor(PhantomData))
    }
}

struct ValueOrVisitor<T>(PhantomData<T>);

impl<'de, T: Regional + Deserialize<'de>> Visitor<'de> for ValueOrVisitor<T> {
    type Value = ValueOr<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, or {}", Value::WHAT, T::WHAT)
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<ValueOr<T>, E> {
        ValueVisitor.visit_f64(number).map(ValueOr::One)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<ValueOr<T>, E> {
        ValueVisitor.visit_i64(number).map(ValueOr::One)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<ValueOr<T>, E> {
        ValueVisitor.visit_str(text).map(ValueOr::One)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<ValueOr<T>, A::Error> {
        T::deserialize(SeqAccessDeserializer::new(list)).map(ValueOr::Other)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<ValueOr<T>, A::Error> {
        T::deserialize(MapAccessDeserializer::new(map)).map(ValueOr::Other)
    }
}
