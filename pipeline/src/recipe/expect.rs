//! `[expect]`: bounds on the numbers of a report.

use octruss_base::suggestion::suggestion;

use crate::error::{ConfigError, ConfigPlace};
use crate::report::{Bounds, Outcome, Report};

/// Bounds on one number of the report.
#[derive(Debug, Clone, PartialEq)]
pub struct Expectation {
    /// The number's name, such as `solve.box-spline.iterations`.
    pub name: String,
    /// What it must keep.
    pub bounds: Bounds,
    /// Where the config says so.
    pub place: ConfigPlace,
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
