//! What a solve was done with.

use octruss_base::choice::Choice;
use octruss_fem::{Method, Options, Solver, Unknown};
use octruss_solver::{Precision, Preconditioner, ResolvedOptions, Smoother};
use serde::{Deserialize, Serialize};

/// What a solve was done with, by the names that configs use.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodFigures {
    /// `cg`, `flexible-cg` where the cycle is not symmetric, or `cycle`.
    pub method: String,
    /// The shape of the cycle.
    pub cycle: String,
    /// How full multigrid brought solutions to finer levels, where it did.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub full_transfer: Option<String>,
    /// What one sweep is.
    pub smoother: String,
    /// The degree of the polynomial, where the smoother is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub smoothing_degree: Option<usize>,
    /// Sweeps before and after the coarse correction.
    pub sweeps: [usize; 2],
    /// The precision inside the cycle.
    pub precision: String,
}

impl MethodFigures {
    /// What the multigrid of a solver is used as, and how its full pass transfers if it
    /// has one.
    pub(crate) fn new<E: Unknown>(options: &Options, solver: &Solver<E>) -> Self {
        let multigrid = &solver.multigrid;
        let ResolvedOptions { smoother, before, after, precision, .. } = *multigrid.options();
        let method = match options.method() {
            Method::ConjugateGradients if !multigrid.is_symmetric() => "flexible-cg",
            method => method.name(),
        };
        let smoothing_degree = match smoother {
            Smoother::Chebyshev { degree, .. } => Some(degree),
            _ => None,
        };
        Self {
            method: method.into(),
            cycle: options.cycle().name().into(),
            full_transfer: solver.full_transfer().map(|transfer| transfer.name().into()),
            smoother: smoother.name().into(),
            smoothing_degree,
            sweeps: [before, after],
            precision: Precision::name(precision).into(),
        }
    }

    /// The shape of the cycle with its sweeps: `v(1,1)`.
    pub fn cycle_and_sweeps(&self) -> String {
        let [before, after] = self.sweeps;
        format!("{}({before},{after})", self.cycle)
    }

    /// The smoother with its degree, if it has one: `chebyshev-3`.
    pub fn smoother_and_degree(&self) -> String {
        let degree = self.smoothing_degree.map(|degree| format!("-{degree}"));
        format!("{}{}", self.smoother, degree.unwrap_or_default())
    }
}
