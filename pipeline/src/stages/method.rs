//! Which iteration and which cycle solve a problem: what the keys of a stage say,
//! what stands for `auto`, and how the report tells it.

use octruss_solver::{
    Csr, CycleShape, Error, Multigrid, MultigridOptions, Precision, Preconditioner, Smoother,
    SolveOptions, SolveReport, SystemEntry, conjugate_gradients, stationary_iteration,
};
use serde::Serialize;

use super::full::FullTransfer;
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

/// The shape of the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cycle {
    /// Coarser levels are visited once.
    V,
    /// Coarser levels are visited twice from each level.
    W,
    /// A pass of full multigrid, with one V-cycle a level, finds the start; the
    /// iteration goes on with V-cycles.
    Full,
}

impl Choice for Cycle {
    const WHAT: &'static str = "cycle";
    const ALL: &'static [Self] = &[Self::V, Self::W, Self::Full];
    fn name(self) -> &'static str {
        match self {
            Self::V => "v",
            Self::W => "w",
            Self::Full => "full",
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
    /// How full multigrid brought solutions to finer levels, where it did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub full_transfer: Option<&'static str>,
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

impl MethodFigures {
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

impl Solve {
    /// The cycle that the keys ask for.
    pub(crate) fn multigrid_options(&self) -> MultigridOptions {
        let auto = MultigridOptions::default();
        let smoother = match (self.smoother.0, self.smoothing_degree) {
            // A degree asks for the polynomial.
            (None | Some(Smoother::Chebyshev { .. }), Some(degree)) => {
                Some(Smoother::chebyshev(degree.get().into()))
            }
            (given, _) => given,
        };
        let [before, after] = self.sweeps.0.map(usize::from);
        let shape = match self.cycle() {
            Cycle::V | Cycle::Full => CycleShape::V,
            Cycle::W => CycleShape::W,
        };
        let precision = self.precision.0.unwrap_or(auto.precision);
        MultigridOptions { smoother, shape, before, after, precision, ..auto }
    }

    /// Iterates as the keys ask.
    pub(super) fn iterate<E: SystemEntry>(
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

    /// What `multigrid` is used as, and how its full pass transferred if it had one.
    pub(crate) fn method_figures<E: SystemEntry>(
        &self,
        multigrid: &Multigrid<E>,
        full_transfer: Option<FullTransfer>,
    ) -> MethodFigures {
        let MultigridOptions { smoother, before, after, precision, .. } = *multigrid.options();
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
            cycle: self.cycle().name(),
            full_transfer: full_transfer.map(Choice::name),
            smoother: smoother.name(),
            smoothing_degree,
            sweeps: [before, after],
            precision: Precision::name(precision),
        }
    }

    fn method(&self) -> Method {
        self.method.0.unwrap_or(Method::ConjugateGradients)
    }

    pub(super) fn cycle(&self) -> Cycle {
        self.cycle.0.unwrap_or(Cycle::V)
    }

    /// Why `key` cannot be given beside the smoother or cycle given, if it cannot.
    pub(super) fn misplaced<'a>(
        key: &str,
        option: impl Fn(&str) -> Option<&'a str>,
    ) -> Option<String> {
        match key {
            "smoothing-degree" => {
                // A degree makes a polynomial of `auto`.
                let needed_or_auto = [Smoother::CHEBYSHEV; 2];
                belongs(key, "smoother", needed_or_auto, option, "this stage smooths by")
            }
            "full-transfer" => {
                belongs(key, "cycle", [Cycle::Full, Cycle::V], option, "the cycle of this stage is")
            }
            _ => None,
        }
    }
}

/// Why `key`, which goes with one choice of `owner` alone, does not go with the one
/// given or with `auto`, if it does not.
fn belongs<'a, T: Choice>(
    key: &str,
    owner: &str,
    [needed, auto]: [T; 2],
    option: impl Fn(&str) -> Option<&'a str>,
    but: &str,
) -> Option<String> {
    let given = match option(owner) {
        None | Some("auto") => auto.name(),
        // A name that is none is told when the value is read.
        Some(given) => T::ALL.iter().map(|choice| choice.name()).find(|name| *name == given)?,
    };
    let needed = needed.name();
    (given != needed)
        .then(|| format!("`{key}` belongs to {owner} = \"{needed}\", but {but} \"{given}\""))
}
