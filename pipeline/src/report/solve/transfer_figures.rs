//! How one transfer came out.

use octruss_fem::TransferSummary;
use octruss_mesh::CorrectedRows;
use serde::{Deserialize, Serialize};

use crate::null::null_as_nan;

/// What is known of one transfer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TransferFigures {
    /// What prolongs.
    pub prolongation: String,
    /// How far the matrix misses linear functions, in mean edge lengths; of
    /// `smoothed-linear` the one that is smoothed.
    #[serde(deserialize_with = "null_as_nan")]
    pub affine_defect: f64,
    /// The same before rows were corrected.
    #[serde(deserialize_with = "null_as_nan")]
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

impl From<&TransferSummary> for TransferFigures {
    fn from(summary: &TransferSummary) -> Self {
        let CorrectedRows { corrected, replaced, extended, left } = summary.corrected;
        Self {
            prolongation: summary.prolongation.into(),
            affine_defect: summary.affine_defect,
            affine_defect_before: summary.affine_defect_before,
            corrected_rows: corrected,
            replaced_rows: replaced,
            extended_rows: extended,
            left_rows: left,
        }
    }
}
