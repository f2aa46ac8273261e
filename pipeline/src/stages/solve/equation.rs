//! The equations that can be solved.

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
}
