//! What prolongs: by name, for all transfers alike or for the finest apart.

use std::fmt;

use octruss_mesh::Scheme;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};

use octruss_base::choice::{Choice, Named};

/// The matrices of one transfer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ProlongationKind {
    /// Those of a scheme.
    Scheme(Scheme),
    /// Linear interpolation, smoothed by a step of Jacobi's method.
    SmoothedLinear,
}

impl ProlongationKind {
    /// The scheme whose weights it begins with.
    pub fn scheme(self) -> Scheme {
        match self {
            Self::Scheme(scheme) => scheme,
            Self::SmoothedLinear => Scheme::Linear,
        }
    }
}

const _: () = assert!(Scheme::ALL.len() == 6, "the list below has all schemes");

impl Choice for ProlongationKind {
    const WHAT: &'static str = "prolongation";
    const ALL: &'static [Self] = &[
        Self::Scheme(Scheme::ALL[0]),
        Self::Scheme(Scheme::ALL[1]),
        Self::Scheme(Scheme::ALL[2]),
        Self::Scheme(Scheme::ALL[3]),
        Self::Scheme(Scheme::ALL[4]),
        Self::Scheme(Scheme::ALL[5]),
        Self::SmoothedLinear,
    ];
    fn name(self) -> &'static str {
        match self {
            Self::Scheme(scheme) => scheme.name(),
            Self::SmoothedLinear => "smoothed-linear",
        }
    }
}

/// The matrices of all transfers: one name, or `{ finest = …, coarser = … }`.
///
/// ```
/// use octruss_fem::{ProlongationKind, Prolongations};
/// use octruss_mesh::Scheme;
/// let finest = ProlongationKind::Scheme(Scheme::BoxSpline);
/// let both = Prolongations { finest, ..Scheme::Linear.into() };
/// assert_eq!(both.to_string(), "box-spline/linear");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prolongations {
    /// On the transfer to the finest level.
    pub finest: ProlongationKind,
    /// On all others.
    pub coarser: ProlongationKind,
}

impl From<ProlongationKind> for Prolongations {
    fn from(everywhere: ProlongationKind) -> Self {
        Self { finest: everywhere, coarser: everywhere }
    }
}

impl From<Scheme> for Prolongations {
    fn from(scheme: Scheme) -> Self {
        ProlongationKind::Scheme(scheme).into()
    }
}

impl fmt::Display for Prolongations {
    /// The name by which reports and expectations call it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.finest.name())?;
        if self.coarser != self.finest {
            write!(f, "/{}", self.coarser.name())?;
        }
        Ok(())
    }
}

impl<'de> Deserialize<'de> for Prolongations {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ProlongationsVisitor)
    }
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct ByTransfer {
    finest: Named<ProlongationKind>,
    coarser: Named<ProlongationKind>,
}

struct ProlongationsVisitor;

impl<'de> Visitor<'de> for ProlongationsVisitor {
    type Value = Prolongations;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "the name of a prolongation, or { finest = \"box-spline\", coarser = \"linear\" }",
        )
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Prolongations, E> {
        name.parse()
            .map(|Named(prolongation)| ProlongationKind::into(prolongation))
            .map_err(E::custom)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Prolongations, A::Error> {
        let given = ByTransfer::deserialize(MapAccessDeserializer::new(map))?;
        Ok(Prolongations { finest: given.finest.0, coarser: given.coarser.0 })
    }
}
