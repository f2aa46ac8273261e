//! Which equation a stage solves, with the keys that belong to it.

use serde::Deserialize;
use toml::Spanned;

use super::biharmonic::BiharmonicKeys;
use super::elasticity::ElasticityKeys;
use super::equation::Equation;
use super::fixed::Fixed;
use super::poisson::PoissonKeys;
use crate::options::option_names;

/// An equation with its data, by the names that a config uses.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProblemKeys {
    /// −div(k grad u) = f.
    Poisson(PoissonKeys),
    /// Δ²u = f, in mixed form.
    Biharmonic(BiharmonicKeys),
    /// −div σ(u) = f, linear and isotropic.
    Elasticity(Box<ElasticityKeys>),
}

impl Default for ProblemKeys {
    fn default() -> Self {
        Self::Poisson(PoissonKeys::default())
    }
}

impl ProblemKeys {
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

impl Equation {
    /// The keys that say what is to be solved.
    pub fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Poisson => option_names::<PoissonKeys>(),
            Self::Biharmonic => option_names::<BiharmonicKeys>(),
            Self::Elasticity => option_names::<ElasticityKeys>(),
        }
    }
}
