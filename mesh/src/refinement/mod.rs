//! What a refinement leaves behind: its matrix, who descends from whom, and how fields go down.

pub mod affine_correction;
pub mod ancestors;
pub mod ancestry;
pub mod carry;
pub(crate) mod folded;
pub mod guard_report;
pub mod interpolation_report;
pub mod lineage;
pub mod refinement;
pub mod sided_field;
pub mod subdivision_matrix;
