//! From the options to the transfers of a multigrid.

use crate::discretisation::discretise::Discretisation;
use crate::discretisation::unknown::Unknown;
use crate::error::Error;
use crate::options::prolongations::{ProlongationKind, Prolongations};
use crate::options::solving::Options;
use crate::transfer::restrict_to_free;
use octruss_base::choice::Choice;
use octruss_mesh::{CorrectedRows, Hierarchy, Prolongation};
use octruss_solver::Transfer;

/// What is known of one transfer.
#[derive(Debug, Clone, PartialEq)]
pub struct TransferSummary {
    /// What prolongs, by its name.
    pub prolongation: &'static str,
    /// How far the matrix misses linear functions, in mean edge lengths; of
    /// `smoothed-linear` the one that is smoothed.
    pub affine_defect: f64,
    /// The same before rows were corrected.
    pub affine_defect_before: f64,
    /// Which rows were.
    pub corrected: CorrectedRows,
}

/// What prolongs on a transfer, and its matrix.
pub(crate) struct Made<'h> {
    kind: ProlongationKind,
    made: Prolongation<'h>,
}

/// What the options ask for on each transfer, coarsest first, with the usual prolongation if
/// they leave it open.
pub(crate) fn prolongations<'h>(
    hierarchy: &'h Hierarchy,
    usual: Prolongations,
    options: &Options,
) -> Vec<Made<'h>> {
    let Prolongations { finest, coarser } = options.prolongation.unwrap_or(usual);
    let count = hierarchy.transfers();
    let make = |transfer: usize| {
        let kind = if transfer + 1 == count { finest } else { coarser };
        let which = options.matrix(kind, hierarchy.refinement(transfer));
        Made { kind, made: hierarchy.prolongation(transfer, which) }
    };
    (0..count).map(make).collect()
}

/// The transfers between free unknowns, coarsest first.
pub(crate) fn transfers<E: Unknown>(
    discretisation: &Discretisation<E>,
    made: &[Made],
    options: &Options,
) -> Result<Vec<Transfer<E>>, Error> {
    let mut transfers = Vec::new();
    for (Made { kind, made }, pair) in made.iter().zip(discretisation.levels.windows(2)) {
        let prolongation = restrict_to_free(&made.matrix, &pair[1].dofs, &pair[0].dofs)?;
        let smooth = *kind == ProlongationKind::SmoothedLinear;
        transfers.push(Transfer { prolongation, smooth, coarse_matrix: None });
    }
    if options.reassembles() {
        for (transfer, matrix) in transfers.iter_mut().zip(&discretisation.coarse_matrices) {
            transfer.coarse_matrix = Some(matrix.clone());
        }
    }
    Ok(transfers)
}

/// What is known of each, coarsest first.
pub(crate) fn summaries(hierarchy: &Hierarchy, made: &[Made]) -> Vec<TransferSummary> {
    let summary = |(transfer, Made { kind, made }): (usize, &Made)| {
        let affine_defect = hierarchy.affine_defect(transfer, &made.matrix);
        TransferSummary {
            prolongation: kind.name(),
            affine_defect,
            affine_defect_before: made.defect_before.unwrap_or(affine_defect),
            corrected: made.corrected,
        }
    };
    made.iter().enumerate().map(summary).collect()
}

impl<E: Unknown> Discretisation<'_, E> {
    /// The transfers between free unknowns, coarsest first.
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`], if levels and matrices do not fit together.
    pub fn transfers(&self, options: &Options) -> Result<Vec<Transfer<E>>, Error> {
        transfers(self, &prolongations(self.hierarchy, self.usual_prolongation, options), options)
    }

    /// What is known of them, coarsest first. Makes the matrices anew: a [`Solver`] that
    /// was set up has it at hand.
    ///
    /// [`Solver`]: crate::Solver
    pub fn transfer_summaries(&self, options: &Options) -> Vec<TransferSummary> {
        summaries(self.hierarchy, &prolongations(self.hierarchy, self.usual_prolongation, options))
    }
}
