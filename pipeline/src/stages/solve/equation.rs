//! The equations that can be solved.

use octruss_base::choice::Choice;

/// The equations that can be solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Equation {
    /// −div(k grad u) = f.
    Poisson,
    /// Δ²u = f, in mixed form.
    Biharmonic,
    /// −div σ(u) = f, linear and isotropic.
    Elasticity,
}

impl Choice for Equation {
    const WHAT: &'static str = "problem";
    const ALL: &'static [Self] = &[Self::Poisson, Self::Biharmonic, Self::Elasticity];
    fn name(self) -> &'static str {
        match self {
            Self::Poisson => "poisson",
            Self::Biharmonic => "biharmonic",
            Self::Elasticity => "elasticity",
        }
    }
}
