//! What solving a problem brings.

use octruss_meshio::Field;

use crate::report::{BodyFigures, FreePartFigures, SolveFigures};

/// What solving a problem brings.
#[derive(Default)]
pub(super) struct Outcome {
    pub(super) solves: Vec<SolveFigures>,
    pub(super) assembly_seconds: f64,
    pub(super) body: Option<BodyFigures>,
    pub(super) free_parts: Vec<FreePartFigures>,
    pub(super) point_fields: Vec<Field>,
    pub(super) cell_fields: Vec<Field>,
    /// What a user should know.
    pub(super) notes: Vec<String>,
}
