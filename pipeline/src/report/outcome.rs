//! What was expected of a run, and whether it came so.

use serde::{Deserialize, Serialize};

/// The least and the greatest value allowed; at least one is given.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "GivenBounds")]
pub struct Bounds {
    /// Not less than this.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// Not more than this.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "bounds such as { min = 1, max = 2 }")]
struct GivenBounds {
    min: Option<f64>,
    max: Option<f64>,
}

impl TryFrom<GivenBounds> for Bounds {
    type Error = String;

    fn try_from(given: GivenBounds) -> Result<Self, String> {
        match (given.min, given.max) {
            (None, None) => Err("an expectation needs `min`, `max` or both".into()),
            (Some(min), Some(max)) if min > max => {
                Err(format!("no number is at least {min} and at most {max}"))
            }
            (min, max) => Ok(Self { min, max }),
        }
    }
}

impl Bounds {
    /// Whether a number keeps the bounds; NaN never does.
    pub fn hold(&self, number: f64) -> bool {
        self.min.is_none_or(|min| number >= min) && self.max.is_none_or(|max| number <= max)
    }
}

/// An expectation with what was measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// The number's name.
    pub name: String,
    /// The number found in the report.
    pub measured: f64,
    /// What it should keep.
    #[serde(flatten)]
    pub bounds: Bounds,
    /// Whether it does.
    pub met: bool,
}

impl std::fmt::Display for Outcome {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "`{}` is {}, expected ", self.name, self.measured)?;
        match (self.bounds.min, self.bounds.max) {
            (Some(min), Some(max)) => write!(f, "{min} to {max}"),
            (Some(min), None) => write!(f, "at least {min}"),
            (None, Some(max)) => write!(f, "at most {max}"),
            (None, None) => write!(f, "anything"),
        }
    }
}
