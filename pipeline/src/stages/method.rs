//! Which iteration and which cycle solve a problem: what the keys of a stage say,
//! what stands for `auto`, and how the report tells it.

use octruss_solver::{
    Csr, CycleShape, Entry, Error, Multigrid, MultigridOptions, Precision, Preconditioner,
    Smoother, SolveOptions, SolveReport, conjugate_gradients, stationary_iteration,
};
use serde::Serialize;

use super::solve::Solve;
use crate::recipe::Choice;

/// What the cycle is used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// As preconditioner of conjugate gradients, in their flexible form where it is
    /// not symmetric.
    ConjugateGradients,
    /// Alone: cycle after cycle.
    Cycle,
}

impl Choice for Method {
    const WHAT: &'static str = "method";
    const ALL: &'static [Self] = &[Self::ConjugateGradients, Self::Cycle];
    fn name(self) -> &'static str {
        match self {
            Self::ConjugateGradients => "cg",
            Self::Cycle => "cycle",
        }
    }
}

/// What a solve was done with, by the names that configs use.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodFigures {
    /// `cg`, `flexible-cg` where the cycle is not symmetric, or `cycle`.
    pub method: &'static str,
    /// The shape of the cycle.
    pub cycle: &'static str,
    /// What one sweep is.
    pub smoother: &'static str,
    /// The degree of the polynomial, where the smoother is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub smoothing_degree: Option<usize>,
    /// Sweeps before and after the coarse correction.
    pub sweeps: [usize; 2],
    /// The precision inside the cycle.
    pub precision: &'static str,
}

impl Solve {
    /// The cycle that the keys ask for.
    pub(crate) fn multigrid_options(&self) -> MultigridOptions {
        let auto = MultigridOptions::default();
        let smoother = match (self.smoother.0.unwrap_or(auto.smoother), self.smoothing_degree) {
            (Smoother::Chebyshev { lower, .. }, Some(degree)) => {
                Smoother::Chebyshev { degree: degree.get().into(), lower }
            }
            (smoother, _) => smoother,
        };
        let [before, after] = self.sweeps.0.map(usize::from);
        let shape = self.cycle.0.unwrap_or(auto.shape);
        let precision = self.precision.0.unwrap_or(auto.precision);
        MultigridOptions { smoother, shape, before, after, precision, ..auto }
    }

    /// Iterates as the keys ask.
    pub(super) fn iterate<E: Entry<Real = f64>>(
        &self,
        (matrix, rhs): (&Csr<E>, &[E::Nodal]),
        multigrid: &mut Multigrid<E>,
        stop: &SolveOptions,
    ) -> Result<(Vec<E::Nodal>, SolveReport), Error> {
        match self.method() {
            Method::ConjugateGradients => conjugate_gradients(matrix, rhs, multigrid, stop),
            Method::Cycle => stationary_iteration(matrix, rhs, multigrid, stop),
        }
    }

    /// What `multigrid` is used as.
    pub(super) fn method_figures<E: Entry<Real = f64>>(
        &self,
        multigrid: &Multigrid<E>,
    ) -> MethodFigures {
        let MultigridOptions { smoother, shape, before, after, precision, .. } =
            *multigrid.options();
        let method = match self.method() {
            Method::ConjugateGradients if !multigrid.is_symmetric() => "flexible-cg",
            method => method.name(),
        };
        let smoothing_degree = match smoother {
            Smoother::Chebyshev { degree, .. } => Some(degree),
            _ => None,
        };
        MethodFigures {
            method,
            cycle: CycleShape::name(shape),
            smoother: smoother.name(),
            smoothing_degree,
            sweeps: [before, after],
            precision: Precision::name(precision),
        }
    }

    fn method(&self) -> Method {
        self.method.0.unwrap_or(Method::ConjugateGradients)
    }

    /// Why `smoothing-degree` cannot be given beside this smoother, if it cannot.
    pub(super) fn misplaced_degree(key: &str, smoother: Option<&str>) -> Option<String> {
        let polynomial = Smoother::CHEBYSHEV.name();
        // A name that is none is told when the value is read.
        let given = smoother.and_then(|given| {
            Smoother::ALL.iter().map(|choice| choice.name()).find(|name| *name == given)
        })?;
        (key == "smoothing-degree" && given != polynomial).then(|| {
            format!(
                "`{key}` belongs to smoother = \"{polynomial}\", but this stage smooths by \"{given}\""
            )
        })
    }
}
