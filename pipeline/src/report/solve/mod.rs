//! What a stage `solve` did.

mod body_figures;
mod free_part_figures;
mod method_figures;
mod solve_figures;
mod solve_report;
mod traffic_figures;
mod transfer_figures;

pub use body_figures::{BodyFigures, Force, ForceFigures, SurfaceForce};
pub use free_part_figures::FreePartFigures;
pub use method_figures::MethodFigures;
pub use solve_figures::SolveFigures;
pub use solve_report::SolveStageReport;
pub use traffic_figures::{KernelFigures, TrafficFigures};
pub use transfer_figures::TransferFigures;
