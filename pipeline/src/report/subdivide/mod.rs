//! What refining did.

mod carried_fields;
mod level_report;
mod marking_figures;
mod strata_counts;
mod subdivide_report;

pub use carried_fields::{CarriedFields, FieldFigures};
pub(crate) use level_report::AT_LIMIT;
pub use level_report::{GuardFigures, InterpolationFigures, LevelReport, LimitFigures};
pub use marking_figures::MarkingFigures;
pub use strata_counts::{ReasonCounts, StrataCounts};
pub use subdivide_report::SubdivideReport;
