//! What flows between the stages of a run.

mod derived_fields;
mod floats;
mod input_numbers;
mod mesh_phase;
mod refine_error;
mod run_state;
mod sided_fields;

pub use derived_fields::DerivedFields;
pub(crate) use floats::floats;
pub use input_numbers::InputNumbers;
pub use mesh_phase::{MeshPhase, Missing};
pub use refine_error::RefineError;
pub use run_state::State;
pub use sided_fields::SidedFields;
