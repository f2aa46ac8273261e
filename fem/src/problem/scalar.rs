//! Data of a problem: numbers, or functions of the position.

use std::fmt;
use std::sync::Arc;

/// A number, or a number for each position.
#[derive(Clone)]
pub enum Scalar {
    /// The same everywhere.
    Constant(f64),
    /// A function of the position in mesh units.
    Function(Function),
}

/// A function of the position, with the text it was written as, if any.
#[derive(Clone)]
pub struct Function {
    text: Option<Arc<str>>,
    f: Arc<dyn Fn([f64; 3]) -> f64 + Send + Sync>,
}

impl Scalar {
    /// A function of the position.
    ///
    /// ```
    /// let height = octruss_fem::Scalar::function(|[_, _, z]| 2.0 * z);
    /// assert_eq!(height.at([0.0, 0.0, 1.5]), 3.0);
    /// ```
    pub fn function(f: impl Fn([f64; 3]) -> f64 + Send + Sync + 'static) -> Self {
        Self::Function(Function { text: None, f: Arc::new(f) })
    }

    /// A function of the position that errors call by the text a user wrote.
    pub fn expression(
        text: impl Into<Arc<str>>,
        f: impl Fn([f64; 3]) -> f64 + Send + Sync + 'static,
    ) -> Self {
        Self::Function(Function { text: Some(text.into()), f: Arc::new(f) })
    }

    /// The value at one position.
    #[inline]
    pub fn at(&self, position: [f64; 3]) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Function(function) => (function.f)(position),
        }
    }

    /// Whether it is the same everywhere.
    pub fn is_constant(&self) -> bool {
        matches!(self, Self::Constant(_))
    }

    /// Whether it is known to be 0 everywhere.
    pub(crate) fn is_zero(&self) -> bool {
        matches!(self, Self::Constant(0.0))
    }

    /// The value at a position as errors tell it: with the text, where there is
    /// one, and the position, where it matters.
    pub(crate) fn told_at(&self, position: [f64; 3]) -> String {
        let [x, y, z] = position;
        match self {
            Self::Constant(value) => value.to_string(),
            Self::Function(function) => {
                let text = function.text.as_ref().map_or("".into(), |text| format!("`{text}` = "));
                format!("{text}{} at ({x}, {y}, {z})", (function.f)(position))
            }
        }
    }
}

impl From<f64> for Scalar {
    fn from(value: f64) -> Self {
        Self::Constant(value)
    }
}

/// Equal numbers, equal texts, or the very same function.
impl PartialEq for Scalar {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Constant(a), Self::Constant(b)) => a == b,
            (Self::Function(a), Self::Function(b)) => {
                Arc::ptr_eq(&a.f, &b.f) || (a.text.is_some() && a.text == b.text)
            }
            _ => false,
        }
    }
}

impl fmt::Debug for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant(value) => write!(f, "{value}"),
            Self::Function(function) => f.write_str(function.text.as_deref().unwrap_or("function")),
        }
    }
}

/// The values of several scalars at one position.
#[inline]
pub(crate) fn values_at<const K: usize>(scalars: &[Scalar; K], position: [f64; 3]) -> [f64; K] {
    std::array::from_fn(|k| scalars[k].at(position))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_tell_text_and_position_of_a_function_and_the_number_alone_of_a_constant() {
        let inverse = Scalar::expression("1/x", |[x, ..]| 1.0 / x);
        assert_eq!(inverse.told_at([0.0, 1.5, 2.0]), "`1/x` = inf at (0, 1.5, 2)");
        assert_eq!(Scalar::function(|_| 2.0).told_at([0.0; 3]), "2 at (0, 0, 0)");
        assert_eq!(Scalar::from(3.5).told_at([0.0; 3]), "3.5");
        assert_eq!(inverse, Scalar::expression("1/x", |[x, ..]| x.recip()));
        assert_ne!(Scalar::function(|_| 2.0), Scalar::function(|_| 2.0));
    }
}
