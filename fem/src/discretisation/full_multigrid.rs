//! Full multigrid: from the coarsest level up to a start for the iteration.

use crate::discretisation::discretise::Discretisation;
use crate::discretisation::unknown::Unknown;
use crate::error::Error;
use crate::lift::smooth_lift;
use crate::options::choices::{Cycle, FullTransfer};
use crate::options::solving::Options;
use crate::transfer::restrict_to_free;
use octruss_mesh::{Hierarchy, Scheme, SubdivisionMatrix, linear_matrix, quadratic_matrix};
use octruss_solver::{Multigrid, Nodal, kernels};
use std::borrow::Cow;

impl Options {
    /// How full multigrid transfers, if it is asked for. What suits the levels if that is
    /// left open: where a smooth scheme moved their vertices, its matrices carry smooth
    /// functions best; on levels that linear refinement left as they were, quadratic
    /// interpolation does.
    pub fn full_transfer(&self, hierarchy: &Hierarchy) -> Option<FullTransfer> {
        let is_linear = hierarchy.refinements().all(|made| made.scheme == Scheme::Linear);
        let usual = if is_linear { FullTransfer::Quadratic } else { FullTransfer::Scheme };
        (self.cycle() == Cycle::Full).then(|| self.full_transfer.unwrap_or(usual))
    }
}

/// The matrices of all transfers, coarsest first.
fn matrices(transfer: FullTransfer, hierarchy: &Hierarchy) -> Vec<Cow<'_, SubdivisionMatrix>> {
    let topology = |level: usize| &hierarchy.levels()[level].topology;
    let is_uniform = |level: usize| hierarchy.refinement(level).ancestry.is_uniform();
    let matrix = |level: usize| match transfer {
        FullTransfer::Scheme => Cow::Borrowed(&hierarchy.refinement(level).matrix),
        // Only some edges were split: the matrix that made the mesh interpolates these.
        _ if !is_uniform(level) => Cow::Borrowed(&hierarchy.refinement(level).matrix),
        FullTransfer::Quadratic if level > 0 && is_uniform(level - 1) => {
            Cow::Owned(quadratic_matrix(topology(level - 1), topology(level)))
        }
        _ => Cow::Owned(linear_matrix(topology(level))),
    };
    (0..hierarchy.transfers()).map(matrix).collect()
}

/// One pass with one cycle a level, to the unknowns of the difference where there is one.
pub(crate) fn full_pass<E: Unknown>(
    transfer: FullTransfer,
    discretisation: &Discretisation<E>,
    multigrid: &mut Multigrid<E>,
) -> Result<Vec<E::Nodal>, Error> {
    let Discretisation { hierarchy, matrix, levels, coarsest, .. } = discretisation;
    let rhs = discretisation.solved_rhs();
    let matrices = matrices(transfer, hierarchy);
    let transfers = matrices
        .iter()
        .zip(levels.windows(2))
        .map(|(matrix, pair)| restrict_to_free(matrix, &pair[1].dofs, &pair[0].dofs))
        .collect::<Result<Vec<_>, _>>()?;
    let Some(coarsest) = coarsest else {
        let mut x = multigrid.full_multigrid(rhs, &transfers, 1)?;
        // A rigid motion has no energy, but digits of the residual would go with it.
        discretisation.free.iter().for_each(|free| free.null_space.project(&mut x));
        return Ok(x);
    };
    let mut lift = smooth_lift(coarsest, &matrices, levels)?;
    if let Some(difference) = &discretisation.difference {
        let reference = difference.at_unknowns(discretisation.finest().dofs.free());
        lift.iter_mut().zip(&reference).for_each(|(x, reference)| *x = x.minus(*reference));
        discretisation.project(&mut lift);
    }
    let mut rest = rhs.to_vec();
    kernels::residual(matrix, &lift, rhs, &mut rest);
    let mut x = multigrid.full_multigrid(&rest, &transfers, 1)?;
    x.iter_mut().zip(&lift).for_each(|(x, lift)| *x = x.plus(*lift));
    Ok(x)
}
