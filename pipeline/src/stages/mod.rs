//! The steps of a run: one file each, with its options, what it does and what
//! it reports.

mod check;
mod context;
mod corner_fields;
mod field_notes;
mod file_names;
mod groups;
mod import;
mod jumps;
pub(crate) mod solve;
mod stage;
mod stage_contradiction;
mod stale;
mod subdivide;
mod write;

pub use check::Check;
pub use context::{Context, Workplace};
pub use import::Import;
pub use solve::biharmonic::BiharmonicKeys;
pub use solve::elasticity::ElasticityKeys;
pub use solve::equation::Equation;
pub use solve::fixed::Fixed;
pub use solve::keys::Solve;
pub use solve::poisson::PoissonKeys;
pub use solve::problem_keys::ProblemKeys;
pub use stage::Stage;
pub use stage_contradiction::{StageContradiction, Where};
pub use subdivide::Subdivide;
pub use write::Write;
