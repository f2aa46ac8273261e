//! The names that expressions know.

use super::code::Op;

/// The coordinates.
pub(super) const COORDINATES: [&str; 3] = ["x", "y", "z"];

/// The constants.
pub(super) const CONSTANTS: [(&str, f64); 2] =
    [("pi", std::f64::consts::PI), ("e", std::f64::consts::E)];

/// The functions.
pub(super) const FUNCTIONS: [(&str, Op); 25] = [
    ("sin", Op::Unary(f64::sin)),
    ("cos", Op::Unary(f64::cos)),
    ("tan", Op::Unary(f64::tan)),
    ("asin", Op::Unary(f64::asin)),
    ("acos", Op::Unary(f64::acos)),
    ("atan", Op::Unary(f64::atan)),
    ("atan2", Op::Binary(f64::atan2)),
    ("sinh", Op::Unary(f64::sinh)),
    ("cosh", Op::Unary(f64::cosh)),
    ("tanh", Op::Unary(f64::tanh)),
    ("exp", Op::Unary(f64::exp)),
    ("ln", Op::Unary(f64::ln)),
    ("log10", Op::Unary(f64::log10)),
    ("log2", Op::Unary(f64::log2)),
    ("sqrt", Op::Unary(f64::sqrt)),
    ("cbrt", Op::Unary(f64::cbrt)),
    ("hypot", Op::Binary(f64::hypot)),
    ("abs", Op::Unary(f64::abs)),
    ("sign", Op::Unary(sign)),
    ("floor", Op::Unary(f64::floor)),
    ("ceil", Op::Unary(f64::ceil)),
    ("round", Op::Unary(f64::round)),
    ("min", Op::Binary(least)),
    ("max", Op::Binary(greatest)),
    ("if", Op::Select),
];

/// All names that stand for a value.
pub(super) fn values() -> Vec<&'static str> {
    COORDINATES.into_iter().chain(CONSTANTS.map(|(name, _)| name)).collect()
}

/// The sign of a number, 0 for 0 and NaN for NaN.
fn sign(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.signum() }
}

/// Unlike `f64::min`, NaN if either is: a fault must not vanish.
fn least(a: f64, b: f64) -> f64 {
    if a.is_nan() || a < b { a } else { b }
}

fn greatest(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
