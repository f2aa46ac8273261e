//! What a run did, as `report.json` tells it: data, and how it is gathered. The names of
//! the keys are a promise to scripts.

mod check_report;
mod file;
mod finding_report;
mod import_report;
mod numbers;
mod outcome;
mod run_report;
mod solve;
mod stage_report;
mod subdivide;
mod write_report;

pub use check_report::CheckReport;
pub use finding_report::FindingReport;
pub use import_report::ImportReport;
pub use outcome::{Bounds, Outcome};
pub use run_report::{Report, SCHEMA};
pub use solve::{
    BodyFigures, Force, ForceFigures, FreePartFigures, KernelFigures, MethodFigures, SolveFigures,
    SolveStageReport, SurfaceForce, TrafficFigures, TransferFigures,
};
pub use stage_report::{Done, StageReport};
pub(crate) use subdivide::AT_LIMIT;
pub use subdivide::{
    CarriedFields, FieldFigures, GuardFigures, InterpolationFigures, LevelReport, LimitFigures,
    MarkingFigures, ReasonCounts, StrataCounts, SubdivideReport,
};
pub use write_report::WriteReport;
