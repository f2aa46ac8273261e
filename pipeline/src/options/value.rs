//! Numbers that a config may give: checked when read.

use std::fmt;
use std::str::FromStr;

use octruss_fem::{Scalar, Vector};
use serde::de::{Deserialize, Deserializer, Error, Visitor};

use crate::expression::{Expression, ExpressionError};

/// A number, or an expression in x, y and z.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// The same everywhere, finite.
    Number(f64),
    /// Different from place to place.
    Expression(Expression),
}

/// Three of them: the components of a vector.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(try_from = "Vec<Value>")]
pub struct VectorValue(pub [Value; 3]);

/// An angle from 0 to 180 degrees.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(try_from = "f64")]
pub struct Degrees(pub f64);

/// A number from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(try_from = "f64")]
pub struct Fraction(pub f64);

/// The two ends of an edge, by their numbers.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(try_from = "Vec<u32>")]
pub struct Ends(pub [u32; 2]);

impl TryFrom<Vec<u32>> for Ends {
    type Error = String;

    fn try_from(list: Vec<u32>) -> Result<Self, String> {
        let found = list.len();
        let two = list.try_into().map(Self);
        two.map_err(|_| format!("expected the two ends of an edge, found {found} numbers"))
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

impl FromStr for Degrees {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number: f64 = text.parse().map_err(|_| "expected a number of degrees".to_string())?;
        Self::try_from(number)
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

impl TryFrom<Vec<Value>> for VectorValue {
    type Error = String;

    fn try_from(list: Vec<Value>) -> Result<Self, String> {
        let found = list.len();
        let three = list.try_into().map(Self);
        three.map_err(|_| format!("expected a list of three, x, y and z, found {found}"))
    }
}

impl Value {
    /// For the solver.
    pub fn to_scalar(&self) -> Scalar {
        match self {
            Self::Number(number) => Scalar::from(*number),
            Self::Expression(expression) => expression.to_scalar(),
        }
    }

    /// From a text: a number if it does not vary.
    fn from_text(text: &str) -> Result<Self, String> {
        let expression: Expression =
            text.parse().map_err(|error: ExpressionError| error.to_string())?;
        match expression.constant() {
            Some(number) if number.is_finite() => Ok(Self::Number(number)),
            Some(number) => Err(format!("expected a finite number, but \"{text}\" is {number}")),
            None => Ok(Self::Expression(expression)),
        }
    }
}

impl VectorValue {
    /// (0, 0, 0).
    pub const ZERO: Self = Self([Value::Number(0.0), Value::Number(0.0), Value::Number(0.0)]);

    /// For the solver.
    pub fn to_vector(&self) -> Vector {
        [0, 1, 2].map(|k| self.0[k].to_scalar())
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueVisitor)
    }
}

pub(super) struct ValueVisitor;

impl Visitor<'_> for ValueVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an expression in x, y and z")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Value, E> {
        if !number.is_finite() {
            return Err(E::custom(format!("expected a finite number, found {number}")));
        }
        Ok(Value::Number(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Value, E> {
        Ok(Value::Number(number as f64))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Value, E> {
        Value::from_text(text).map_err(E::custom)
    }
}
