//! Expressions that can be evaluated.

use std::fmt;
use std::sync::Arc;

use octruss_fem::Scalar;

use super::code::{self, Op};
use super::fault::Fault;
use super::{parser, tokens};

/// A compiled expression in x, y and z.
///
/// ```
/// use octruss::expression::Expression;
/// let bump: Expression = "if(x < 0.5, 0, 4*(x - 0.5)^2)".parse().unwrap();
/// assert_eq!((bump.at([0.25, 0.0, 0.0]), bump.at([1.0, 0.0, 0.0])), (0.0, 1.0));
/// let error = "sin(x".parse::<Expression>().unwrap_err();
/// assert_eq!(error.to_string(), "expression \"sin(x\", column 6: expected `)`, found its end");
/// ```
#[derive(Clone)]
pub struct Expression {
    text: Arc<str>,
    code: Arc<[Op]>,
}

/// Why a text is no expression, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("expression \"{text}\", column {column}: {message}")]
pub struct ExpressionError {
    /// The whole text.
    pub text: String,
    /// Of the text, from 1, in characters.
    pub column: usize,
    /// What was found, what was expected.
    pub message: String,
}

impl Expression {
    /// The value at a position.
    #[inline]
    pub fn at(&self, position: [f64; 3]) -> f64 {
        code::run(&self.code, position)
    }

    /// What was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The value, if it is the same everywhere.
    pub fn constant(&self) -> Option<f64> {
        let varies = self.code.iter().any(|op| matches!(op, Op::Coordinate(_)));
        (!varies).then(|| self.at([0.0; 3]))
    }

    /// For the solver, with the text for its messages.
    pub fn to_scalar(&self) -> Scalar {
        let expression = self.clone();
        Scalar::expression(self.text.clone(), move |position| expression.at(position))
    }
}

impl std::str::FromStr for Expression {
    type Err = ExpressionError;

    fn from_str(text: &str) -> Result<Self, ExpressionError> {
        let code = tokens::tokens(text).and_then(|tokens| parser::parse(&tokens));
        let error = |fault: Fault| ExpressionError {
            text: text.into(),
            column: text[..fault.at].chars().count() + 1,
            message: fault.message,
        };
        Ok(Self { text: text.into(), code: code.map_err(error)?.into() })
    }
}

impl PartialEq for Expression {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl fmt::Debug for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        let expression: Expression = text.parse().unwrap_or_else(|error| panic!("{error}"));
        expression.at([2.0, 3.0, 0.5])
    }

    #[test]
    fn operators_bind_as_in_mathematics() {
        for (text, exact) in [
            ("1 + 2*3", 7.0),
            ("(1 + 2)*3", 9.0),
            ("7 - 2 - 1", 4.0),
            ("12 / 2 / 3", 2.0),
            ("-x^2", -4.0),
            ("2^-1", 0.5),
            ("2^3^2", 512.0),
            ("--x", 2.0),
            ("2*-y", -6.0),
            ("1e-3*x", 2e-3),
            ("1.5E+2", 150.0),
            (".5 + 2.", 2.5),
            ("x < y and y < 4", 1.0),
            ("x < y and not y >= 3 or z == 0.5", 1.0),
            ("x != 2", 0.0),
            ("not x", 0.0),
            ("1 + (x > 1)*10", 11.0),
        ] {
            assert_eq!(value(text), exact, "{text}");
        }
    }

    #[test]
    fn names_mean_what_they_say() {
        for (text, exact) in [
            ("sin(pi/6) + cos(0)", 1.5),
            ("ln(e^3) + log10(100) + log2(8)", 8.0),
            ("sqrt(x*8) + cbrt(27) + abs(-1)", 8.0),
            ("atan2(1, 1) - pi/4", 0.0),
            ("min(x, max(y, z)) + hypot(3, 4)", 7.0),
            ("max(min(x, y), min(y, 5))", 3.0),
            ("if(z > 1, 1/0, 6)", 6.0),
            ("sign(-3) + floor(1.7) + ceil(1.2) + round(2.6)", 5.0),
            ("tan(0) + asin(0) + acos(1) + atan(0) + sinh(0) + cosh(0) + tanh(0) + exp(0)", 2.0),
        ] {
            assert!((value(text) - exact).abs() < 1e-14, "{text} is {}", value(text));
        }
        assert_eq!("2*pi".parse::<Expression>().unwrap().constant(), Some(std::f64::consts::TAU));
        assert_eq!("2*x".parse::<Expression>().unwrap().constant(), None);
    }

    #[test]
    fn faults_are_told_with_their_column() {
        let deep = "(".repeat(1000);
        let long_sum = "1+(".repeat(50);
        for (text, column, says) in [
            ("", 1, "expected a number, a name or `(`, found its end"),
            ("2 *", 4, "expected a number, a name or `(`, found its end"),
            ("(x", 3, "expected `)`, found its end"),
            ("x)", 2, "expected an operator, found `)`"),
            ("2 x", 3, "expected an operator, found `x`"),
            ("3..5", 3, "expected an operator, found `.5`"),
            ("α*x", 1, "unexpected character `α`"),
            ("x * $y", 5, "unexpected character `$`"),
            ("x = 2", 3, "unexpected `=`; to compare, write `==`"),
            ("sinn(x)", 1, "unknown function `sinn`; did you mean `sin`? (valid: sin, cos, "),
            ("log(x)", 1, "unknown function `log`; write `ln` or `log10`"),
            ("2*t", 3, "unknown name `t` (valid: x, y, z, pi, e)"),
            ("sin x", 1, "`sin` is a function: `sin(…)`"),
            ("x(2)", 2, "expected an operator, found `(`"),
            ("sin(x, y)", 1, "`sin` takes 1 value, found 2"),
            ("if(x, y)", 1, "`if` takes 3 values (condition, then, else), found 2"),
            ("0 < x < 1", 7, "comparisons do not chain; join them with `and`"),
            (&deep, 65, "nested more than 64 deep"),
            (&long_sum, 97, "nested more than 32 deep"),
        ] {
            let error = text.parse::<Expression>().unwrap_err();
            assert!(error.message.starts_with(says), "{text}: {error}");
            assert_eq!(error.column, column, "{text}: {error}");
        }
    }
}
