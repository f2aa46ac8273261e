//! The floor that the quality of tets is kept above.

use std::fmt;
use std::str::FromStr;

use serde::de::{Deserialize, Deserializer, Error, Visitor};

use super::value::Fraction;

/// A mean ratio η that no tet may fall below, or none.
///
/// ```
/// use octruss::options::MinQuality;
/// assert_eq!("0.2".parse(), Ok(MinQuality::Floor(0.2)));
/// assert_eq!("off".parse(), Ok(MinQuality::Off));
/// assert!("on".parse::<MinQuality>().is_err());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MinQuality {
    /// Vertices go where the scheme wants them; a level that inverts a tet is refused.
    Off,
    /// Vertices are pulled back where a tet would fall below.
    Floor(f64),
}

impl TryFrom<f64> for MinQuality {
    type Error = String;

    fn try_from(number: f64) -> Result<Self, String> {
        let Fraction(eta) =
            Fraction::try_from(number).map_err(|expected| format!("{expected} (or \"off\")"))?;
        Ok(Self::Floor(eta))
    }
}

impl FromStr for MinQuality {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match (text, text.parse::<f64>()) {
            ("off", _) => Ok(Self::Off),
            (_, Ok(number)) => Self::try_from(number),
            _ => Err(format!("expected a number from 0 to 1 or \"off\", found \"{text}\"")),
        }
    }
}

impl<'de> Deserialize<'de> for MinQuality {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(MinQualityVisitor)
    }
}

struct MinQualityVisitor;

impl Visitor<'_> for MinQualityVisitor {
    type Value = MinQuality;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number from 0 to 1 or \"off\"")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<MinQuality, E> {
        MinQuality::try_from(number).map_err(E::custom)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<MinQuality, E> {
        self.visit_f64(number as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<MinQuality, E> {
        text.parse().map_err(E::custom)
    }
}
