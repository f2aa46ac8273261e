//! All options of a solve.

use crate::options::choices::{CoarseOperator, Cycle, FullTransfer, Method};
use crate::options::prolongations::{ProlongationKind, Prolongations};
use crate::options::sweeps::Sweeps;
use octruss_base::choice::{Choice, auto, named};
use octruss_mesh::{AffineCorrection, InterfaceRows, ProlongationOptions, Refinement};
use octruss_solver::{CycleShape, MultigridOptions, Precision, Smoother};
use serde::{Deserialize, Deserializer, de::Error};
use std::num::NonZeroU8;

/// How a problem is solved. Nobody has to choose; what is left open (`None`, in configs
/// `"auto"`) is what suits the problem.
///
/// Configs fill this very struct: its fields are keys of the stage `solve`, in kebab case.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Options {
    /// Which matrices prolong; left open those that [`Problem::usual_prolongation`] names.
    /// (Configs give a list of them, to solve with in turn.)
    ///
    /// [`Problem::usual_prolongation`]: crate::Problem::usual_prolongation
    #[serde(skip)]
    pub prolongation: Option<Prolongations>,
    /// Which rows of them are made exact for linear functions.
    #[serde(deserialize_with = "named")]
    pub affine_correction: AffineCorrection,
    /// What their rows on interfaces between regions read.
    #[serde(deserialize_with = "named")]
    pub interface_rows: InterfaceRows,
    /// Where the matrices of coarse levels come from.
    #[serde(deserialize_with = "named")]
    pub coarse_operator: CoarseOperator,
    /// Stop at this residual, relative to the right-hand side; above 0.
    #[serde(deserialize_with = "positive")]
    pub tolerance: f64,
    /// Give up after so many iterations.
    pub max_iterations: usize,
    /// What the cycle is used for; left open conjugate gradients.
    #[serde(deserialize_with = "auto")]
    pub method: Option<Method>,
    /// The shape of the cycle; left open V.
    #[serde(deserialize_with = "auto")]
    pub cycle: Option<Cycle>,
    /// How full multigrid brings solutions to finer levels; left open by the scheme
    /// that refined them, if that is smooth, else quadratic.
    #[serde(deserialize_with = "auto")]
    pub full_transfer: Option<FullTransfer>,
    /// What a smoothing sweep is; left open hybrid Gauss–Seidel for elasticity, else
    /// Chebyshev.
    #[serde(deserialize_with = "auto")]
    pub smoother: Option<Smoother>,
    /// The degree of the Chebyshev smoother, which it asks for; 3 if not given.
    pub smoothing_degree: Option<NonZeroU8>,
    /// Smoothing sweeps before and after each coarse correction.
    pub sweeps: Sweeps,
    /// The precision inside the cycle; left open single where that does, else double.
    #[serde(deserialize_with = "auto")]
    pub precision: Option<Precision>,
}

impl Default for Options {
    /// To 10⁻⁸ by conjugate gradients with a V(1,1)-cycle.
    fn default() -> Self {
        let stop = octruss_solver::SolveOptions::default();
        Self {
            prolongation: None,
            affine_correction: AffineCorrection::default(),
            interface_rows: InterfaceRows::default(),
            coarse_operator: CoarseOperator::Galerkin,
            tolerance: stop.tolerance,
            max_iterations: stop.max_iterations,
            method: None,
            cycle: None,
            full_transfer: None,
            smoother: None,
            smoothing_degree: None,
            sweeps: Sweeps([1, 1]),
            precision: None,
        }
    }
}

/// Options that do not go together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Contradiction {
    /// The one that belongs to another choice, as configs call it.
    pub key: &'static str,
    /// Why it does not go with the choice made.
    pub message: String,
}

impl Options {
    /// The method, chosen or usual.
    pub fn method(&self) -> Method {
        self.method.unwrap_or(Method::ConjugateGradients)
    }

    /// The cycle, chosen or usual.
    pub fn cycle(&self) -> Cycle {
        self.cycle.unwrap_or(Cycle::V)
    }

    /// Whether coarse matrices are assembled on the coarse meshes.
    pub fn reassembles(&self) -> bool {
        self.coarse_operator == CoarseOperator::Reassembled
    }

    /// What the cycle is set up with.
    pub fn multigrid(&self) -> MultigridOptions {
        let usual = MultigridOptions::default();
        let smoother = match (self.smoother, self.smoothing_degree) {
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
        let precision = self.precision;
        MultigridOptions { smoother, shape, before, after, precision, ..usual }
    }

    /// Which matrix prolongs where a refinement was made, the finest or another. A scheme
    /// goes by its name: with the parameters that it refined the mesh with, if it did.
    pub(crate) fn matrix(
        &self,
        prolongation: ProlongationKind,
        refinement: &Refinement,
    ) -> ProlongationOptions {
        let (named, made) = (prolongation.scheme(), refinement.scheme);
        let scheme = if named.name() == made.name() { made } else { named };
        let Self { affine_correction, interface_rows, .. } = *self;
        ProlongationOptions { scheme, affine_correction, interface_rows }
    }

    /// What does not go together, if anything.
    pub fn contradiction(&self) -> Option<Contradiction> {
        let polynomial = Smoother::CHEBYSHEV.name();
        match (self.smoother.map(Choice::name), self.smoothing_degree) {
            (Some(smoother), Some(_)) if smoother != polynomial => {
                let message = format!(
                    "`smoothing-degree` belongs to smoother = \"{polynomial}\", but this stage \
                     smooths by \"{smoother}\""
                );
                return Some(Contradiction { key: "smoothing-degree", message });
            }
            _ => {}
        }
        let (full, cycle) = (Cycle::Full, self.cycle());
        (self.full_transfer.is_some() && cycle != full).then(|| {
            let (full, cycle) = (full.name(), cycle.name());
            let message = format!(
                "`full-transfer` belongs to cycle = \"{full}\", but the cycle of this stage is \
                 \"{cycle}\""
            );
            Contradiction { key: "full-transfer", message }
        })
    }
}

fn positive<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    let number = f64::deserialize(deserializer)?;
    let fits = number > 0.0 && number.is_finite();
    let refused = || D::Error::custom(format!("expected a number above 0, found {number}"));
    fits.then_some(number).ok_or_else(refused)
}
