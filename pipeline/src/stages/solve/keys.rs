//! The keys of a stage `solve`.

use octruss_fem::{Contradiction, Options, Prolongations};
use serde::Deserialize;

use super::problem_keys::ProblemKeys;
use crate::options::Several;
use crate::stages::stage_contradiction::StageContradiction;

/// Solves a problem on the finest mesh by conjugate gradients with a multigrid
/// cycle over all levels, or by cycles alone, in turn with each prolongation. The
/// first solution becomes the field `solution` (of a second such stage `solution-2`),
/// with NaN at vertices of free-standing triangles and edges, which no tet uses. Of
/// elasticity these are `displacement`, and `strain`, `stress` and `von-mises` on
/// tets and recovered at vertices; there one of each material, where there are
/// several, as `stress-REGION`, NaN at vertices without it. Components of tensors
/// come in the order of VTK: xx, yy, zz, xy, yz, xz.
///
/// In a config the keys of the problem and of the options stand beside these.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct Solve {
    /// Which equation, with its data.
    pub problem: ProblemKeys,
    /// Which matrices prolong: those of a scheme or `smoothed-linear`; of a list each in
    /// turn. Left open those that take the least time: linear ones, but box splines for the
    /// biharmonic equation, and for elasticity where a smooth scheme shaped the body.
    pub prolongation: Option<Several<Prolongations>>,
    /// How it is solved.
    pub options: Options,
    /// Measure bytes and bandwidth of each kernel after solving.
    pub account: bool,
}

impl Solve {
    /// What in the options does not go together, if anything.
    pub(in crate::stages) fn contradiction(&self) -> Option<StageContradiction> {
        if let Some(Contradiction { key, message }) = self.options.contradiction() {
            return Some(StageContradiction::of_key(key, message));
        }
        if let ProblemKeys::Elasticity(keys) = &self.problem
            && keys.material.is_none()
        {
            let message = "problem = \"elasticity\" needs `material`, such as \
                { young = 210e3, poisson = 0.3 }";
            return Some(StageContradiction::of_stage(message.into()));
        }
        let equation = self.problem.equation();
        self.problem.fixed().iter().find_map(|fixed| {
            let message = fixed.get_ref().contradiction(equation)?;
            Some(StageContradiction::at(fixed.span(), message))
        })
    }

    /// The options of each solve, one for each prolongation.
    pub(crate) fn in_turn(&self) -> Vec<Options> {
        let with = |prolongation| Options { prolongation, ..self.options };
        match &self.prolongation {
            None => vec![with(None)],
            Some(several) => several.iter().map(|one| with(Some(*one))).collect(),
        }
    }
}
