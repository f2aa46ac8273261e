//! `[expect]`: bounds on the numbers of a report.

use serde::{Deserialize, Serialize};

use crate::error::{ConfigError, Place};
use crate::report::Report;
use octruss_base::suggestion::suggestion;

/// Bounds on one number of the report.
#[derive(Debug, Clone, PartialEq)]
pub struct Expectation {
    /// The number's name, such as `solve.box-spline.iterations`.
    pub name: String,
    /// What it must keep.
    pub bounds: Bounds,
    /// Where the config says so.
    pub place: Place,
}

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
#[derive(Debug, Clone, PartialEq, Serialize)]
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

/// Compares every expectation with the report, in the config's order.
///
/// # Errors
/// An expectation about a number that the report does not have.
pub fn compare(expectations: &[Expectation], report: &Report) -> Result<Vec<Outcome>, ConfigError> {
    let numbers = report.numbers();
    let measure = |expected: &Expectation| {
        let found = numbers.iter().find(|(name, _)| *name == expected.name);
        let measured = found.ok_or_else(|| unknown(expected, &numbers))?.1;
        Ok(Outcome {
            name: expected.name.clone(),
            measured,
            bounds: expected.bounds,
            met: expected.bounds.hold(measured),
        })
    };
    expectations.iter().map(measure).collect()
}

/// Lists the numbers of the stage that the name begins with, or of all.
fn unknown(expected: &Expectation, numbers: &[(String, f64)]) -> ConfigError {
    let names: Vec<&str> = numbers.iter().map(|(name, _)| name.as_str()).collect();
    let stage = |name: &str| name.split('.').next().map(String::from);
    let related: Vec<&str> =
        names.iter().copied().filter(|name| stage(name) == stage(&expected.name)).collect();
    let valid = if related.is_empty() { names } else { related };
    let message = format!(
        "the report has no number `{}`{}",
        expected.name,
        suggestion(&expected.name, &valid)
    );
    ConfigError { place: expected.place.clone(), message }
}
