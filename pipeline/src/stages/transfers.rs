//! From the names of prolongations to the transfers of a multigrid.

use octruss_fem::Error;
use octruss_fem::{LevelUnknowns, restrict_to_free};
use octruss_mesh::{
    AffineCorrection, CorrectedRows, Hierarchy, InterfaceRows, ProlongationOptions,
};
use octruss_solver::{Csr, SystemEntry, Transfer};
use serde::Serialize;

use crate::recipe::{Choice, Prolongation, Prolongations};

/// Where coarse matrices come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CoarseOperator {
    /// Pᵀ A P.
    Galerkin,
    /// Assembled on the coarse meshes.
    Reassembled,
}

impl Choice for CoarseOperator {
    const WHAT: &'static str = "coarse operator";
    const ALL: &'static [Self] = &[Self::Galerkin, Self::Reassembled];
    fn name(self) -> &'static str {
        match self {
            Self::Galerkin => "galerkin",
            Self::Reassembled => "reassembled",
        }
    }
}

/// How levels hang together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransferOptions {
    /// Whose matrices prolong.
    pub prolongations: Prolongations,
    /// Which rows are made exact for linear functions.
    pub affine_correction: AffineCorrection,
    /// What rows on interfaces read.
    pub interface_rows: InterfaceRows,
}

/// What is known of one transfer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TransferFigures {
    /// What prolongs.
    pub prolongation: &'static str,
    /// How far the matrix misses linear functions, in mean edge lengths; of
    /// `smoothed-linear` the one that is smoothed.
    pub affine_defect: f64,
    /// The same before rows were corrected.
    pub affine_defect_before: f64,
    /// Rows made exact on their own support.
    pub corrected_rows: usize,
    /// Rows made linear, which was exact.
    pub replaced_rows: usize,
    /// Rows made exact with more columns.
    pub extended_rows: usize,
    /// Rows that nothing made exact.
    pub left_rows: usize,
}

/// What prolongs on a transfer, and its matrix.
pub struct Made<'a> {
    prolongation: Prolongation,
    made: octruss_mesh::Prolongation<'a>,
}

/// The transfers of a hierarchy, with Galerkin products, and the
/// matrices that they are from, both **coarsest first**.
///
/// # Errors
/// Whatever the solver reports.
pub fn transfers<'a, E: SystemEntry>(
    options: &TransferOptions,
    hierarchy: &'a Hierarchy,
    levels: &[LevelUnknowns<E>],
) -> Result<(Vec<Transfer<E>>, Vec<Made<'a>>), Error> {
    let Prolongations { finest, coarser } = options.prolongations;
    let (mut transfers, mut all) = (Vec::new(), Vec::new());
    for (number, pair) in levels.windows(2).enumerate() {
        let prolongation = if number + 2 == levels.len() { finest } else { coarser };
        let made = hierarchy
            .prolongation(number, matrix_options(prolongation, options, hierarchy, number));
        let matrix = restrict_to_free(&made.matrix, &pair[1].dofs, &pair[0].dofs)?;
        let smooth = prolongation == Prolongation::SmoothedLinear;
        transfers.push(Transfer { prolongation: matrix, smooth, coarse_matrix: None });
        all.push(Made { prolongation, made });
    }
    Ok((transfers, all))
}

/// Figures of each transfer, coarsest first.
pub fn transfer_figures(hierarchy: &Hierarchy, all: &[Made]) -> Vec<TransferFigures> {
    let figures = |(number, Made { prolongation, made }): (usize, &Made)| {
        let CorrectedRows { corrected, replaced, extended, left } = made.corrected;
        let affine_defect = hierarchy.affine_defect(number, &made.matrix);
        TransferFigures {
            prolongation: prolongation.name(),
            affine_defect,
            affine_defect_before: made.defect_before.unwrap_or(affine_defect),
            corrected_rows: corrected,
            replaced_rows: replaced,
            extended_rows: extended,
            left_rows: left,
        }
    };
    all.iter().enumerate().map(figures).collect()
}

/// A scheme goes by its name: with the parameters that it refined the mesh with, if
/// it did.
fn matrix_options(
    prolongation: Prolongation,
    options: &TransferOptions,
    hierarchy: &Hierarchy,
    transfer: usize,
) -> ProlongationOptions {
    let (named, made) = (prolongation.scheme(), hierarchy.refinement(transfer).scheme);
    let scheme = if named.name() == made.name() { made } else { named };
    let TransferOptions { affine_correction, interface_rows, .. } = *options;
    ProlongationOptions { scheme, affine_correction, interface_rows }
}

/// Puts the matrices of coarse levels, **coarsest first**, into transfers; without
/// any, Galerkin products stay.
pub fn reassemble<E: Clone>(transfers: &mut [Transfer<E>], coarse: &[Csr<E>]) {
    for (transfer, matrix) in transfers.iter_mut().zip(coarse) {
        transfer.coarse_matrix = Some(matrix.clone());
    }
}
