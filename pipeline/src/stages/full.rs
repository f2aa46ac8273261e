//! Full multigrid: from the coarsest level up to a start for the iteration.

use std::borrow::Cow;

use octruss_fem::Error;
use octruss_fem::{LevelUnknowns, restrict_to_free, smooth_lift};
use octruss_mesh::{Hierarchy, Scheme, SubdivisionMatrix, linear_matrix, quadratic_matrix};
use octruss_solver::{
    Csr, Multigrid, Nodal, SolveOptions, SystemEntry, conjugate_gradients, kernels,
};

use super::method::Cycle;
use super::multigrid::Discrete;
use super::solve::Solve;
use crate::recipe::Choice;

/// How full multigrid brings the solution of a level to the next finer one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FullTransfer {
    /// By the matrices that refined the mesh.
    Scheme,
    /// By linear interpolation on edges.
    Linear,
    /// By quadratic interpolation on the tets of the level below; linear from the
    /// coarsest level, which has none below.
    Quadratic,
}

impl Choice for FullTransfer {
    const WHAT: &'static str = "transfer";
    const ALL: &'static [Self] = &[Self::Scheme, Self::Linear, Self::Quadratic];
    fn name(self) -> &'static str {
        match self {
            Self::Scheme => "scheme",
            Self::Linear => "linear",
            Self::Quadratic => "quadratic",
        }
    }
}

impl FullTransfer {
    /// What suits the levels: where a smooth scheme moved their vertices, its matrices
    /// carry smooth functions best; on levels that linear refinement left as they
    /// were, quadratic interpolation does.
    fn auto(hierarchy: &Hierarchy) -> Self {
        if hierarchy.refinements().all(|refinement| refinement.scheme == Scheme::Linear) {
            Self::Quadratic
        } else {
            Self::Scheme
        }
    }

    /// The matrices of all transfers, coarsest first.
    fn matrices(self, hierarchy: &Hierarchy) -> Vec<Cow<'_, SubdivisionMatrix>> {
        let topology = |level: usize| &hierarchy.levels()[level].topology;
        let matrix = |level: usize| match self {
            Self::Scheme => Cow::Borrowed(&hierarchy.refinement(level).matrix),
            Self::Quadratic if level > 0 => {
                Cow::Owned(quadratic_matrix(topology(level - 1), topology(level)))
            }
            _ => Cow::Owned(linear_matrix(topology(level))),
        };
        (0..hierarchy.transfers()).map(matrix).collect()
    }

    /// One pass of full multigrid with one cycle a level.
    pub(super) fn full_pass<E: SystemEntry>(
        self,
        hierarchy: &Hierarchy,
        Discrete { matrix, rhs, levels, coarsest, .. }: &Discrete<E>,
        multigrid: &mut Multigrid<E>,
    ) -> Result<Vec<E::Nodal>, Error> {
        let matrices = self.matrices(hierarchy);
        let pairs = matrices.iter().zip(levels.windows(2));
        let transfers = pairs
            .map(|(matrix, pair)| restrict_to_free(matrix, &pair[1].dofs, &pair[0].dofs))
            .collect::<Result<Vec<_>, _>>()?;
        let Some(coarsest) = coarsest else {
            return Ok(multigrid.full_multigrid(rhs, &transfers, 1)?);
        };
        let lift = smooth_lift(coarsest, &matrices, levels)?;
        let mut rest = rhs.clone();
        kernels::residual(matrix, &lift, rhs, &mut rest);
        let mut x = multigrid.full_multigrid(&rest, &transfers, 1)?;
        x.iter_mut().zip(&lift).for_each(|(x, lift)| *x = x.plus(*lift));
        Ok(x)
    }
}

impl Solve {
    /// How full multigrid transfers, if the keys ask for it.
    pub(super) fn full_transfer(&self, hierarchy: &Hierarchy) -> Option<FullTransfer> {
        let asked = self.cycle() == Cycle::Full;
        asked.then(|| self.full_transfer.0.unwrap_or_else(|| FullTransfer::auto(hierarchy)))
    }

    /// The solution of the coarsest level's own problem, if full multigrid needs it:
    /// with it the lift of prescribed values begins.
    pub(super) fn coarsest_solution<E: SystemEntry>(
        &self,
        levels: &[LevelUnknowns<E>],
        assemble: impl FnOnce() -> Result<(Csr<E>, Vec<E::Nodal>), Error>,
    ) -> Result<Option<Vec<E::Nodal>>, Error> {
        let homogeneous = levels.iter().all(LevelUnknowns::is_homogeneous);
        if homogeneous || self.cycle() != Cycle::Full {
            return Ok(None);
        }
        let (matrix, rhs) = assemble()?;
        let mut direct = Multigrid::new(&matrix, Vec::new(), &self.multigrid_options())?;
        let (x, _) = conjugate_gradients(&matrix, &rhs, &mut direct, &SolveOptions::default())?;
        Ok(Some(x))
    }
}
