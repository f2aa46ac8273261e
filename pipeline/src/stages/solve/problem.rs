//! Which equation a stage solves, with the keys that belong to it.

use serde::Deserialize;
use toml::Spanned;

use super::biharmonic::BiharmonicKeys;
use super::elasticity::ElasticityKeys;
use super::fixed::Fixed;
use super::poisson::PoissonKeys;
use crate::options::option_names;

/// An equation with its data, by the names that a config uses.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Problem {
    /// −div(k grad u) = f.
    Poisson(PoissonKeys),
    /// Δ²u = f, in mixed form.
    Biharmonic(BiharmonicKeys),
    /// −div σ(u) = f, linear and isotropic.
    Elasticity(Box<ElasticityKeys>),
}

impl Default for Problem {
    fn default() -> Self {
        Self::Poisson(PoissonKeys::default())
    }
}

/// The equations that can be solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Equation {
    /// Of [`Problem::Poisson`].
    Poisson,
    /// Of [`Problem::Biharmonic`].
    Biharmonic,
    /// Of [`Problem::Elasticity`].
    Elasticity,
}

impl Equation {
    /// All that there are.
    pub const ALL: [Self; 3] = [Self::Poisson, Self::Biharmonic, Self::Elasticity];

    /// As configs call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Poisson => "poisson",
            Self::Biharmonic => "biharmonic",
            Self::Elasticity => "elasticity",
        }
    }

    /// The keys that say what is to be solved.
    pub fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Poisson => option_names::<PoissonKeys>(),
            Self::Biharmonic => option_names::<BiharmonicKeys>(),
            Self::Elasticity => option_names::<ElasticityKeys>(),
        }
    }
}

impl Problem {
    /// Which equation.
    pub fn equation(&self) -> Equation {
        match self {
            Self::Poisson(_) => Equation::Poisson,
            Self::Biharmonic(_) => Equation::Biharmonic,
            Self::Elasticity(_) => Equation::Elasticity,
        }
    }

    /// What is prescribed on surfaces.
    pub fn fixed(&self) -> &[Spanned<Fixed>] {
        match self {
            Self::Poisson(keys) => &keys.fixed,
            Self::Biharmonic(keys) => &keys.fixed,
            Self::Elasticity(keys) => &keys.fixed,
        }
    }
}
