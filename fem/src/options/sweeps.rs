//! How many smoothing sweeps surround a coarse correction.

use std::fmt;

use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Unexpected, Visitor};

/// Sweeps before and after the correction: one number for both, or a list of two
/// of which one may be 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sweeps(pub [u8; 2]);

impl<'de> Deserialize<'de> for Sweeps {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SweepsVisitor)
    }
}

struct SweepsVisitor;

impl<'de> Visitor<'de> for SweepsVisitor {
    type Value = Sweeps;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a whole number from 1 to 255, or a list of two: before and after")
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Sweeps, E> {
        match u8::try_from(number) {
            Ok(sweeps) if sweeps > 0 => Ok(Sweeps([sweeps; 2])),
            _ => Err(E::invalid_value(Unexpected::Signed(number), &self)),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Sweeps, A::Error> {
        match Vec::<u8>::deserialize(SeqAccessDeserializer::new(list))?[..] {
            [0, 0] => Err(A::Error::custom("expected at least one sweep, found none")),
            [before, after] => Ok(Sweeps([before, after])),
            ref list => {
                let found = list.len();
                let message = format!("expected a list of two, before and after, found {found}");
                Err(A::Error::custom(message))
            }
        }
    }
}
