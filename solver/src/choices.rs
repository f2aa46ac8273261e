//! The names of closed choices.

use crate::multigrid::options::{Precision, Smoother};
use octruss_base::choice::Choice;

/// Each with its usual parameters.
impl Choice for Smoother {
    const WHAT: &'static str = "smoother";
    const ALL: &'static [Self] = &[
        Self::CHEBYSHEV,
        Self::HybridGaussSeidel,
        Self::GaussSeidel,
        Self::ColouredGaussSeidel,
        Self::L1Jacobi,
    ];
    fn name(self) -> &'static str {
        match self {
            Self::Chebyshev { .. } => "chebyshev",
            Self::HybridGaussSeidel => "hybrid-gauss-seidel",
            Self::GaussSeidel => "gauss-seidel",
            Self::ColouredGaussSeidel => "coloured-gauss-seidel",
            Self::L1Jacobi => "l1-jacobi",
        }
    }
}

impl Choice for Precision {
    const WHAT: &'static str = "precision";
    const ALL: &'static [Self] = &[Self::Single, Self::Double];
    fn name(self) -> &'static str {
        match self {
            Self::Single => "single",
            Self::Double => "double",
        }
    }
}
