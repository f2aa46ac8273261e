//! From a mesh to a finer one: the schemes' rules, the red split, the guard of quality.

pub mod assemble_matrix;
pub mod error;
pub mod guard;
mod moved;
pub mod neighbourhoods;
pub mod octets;
pub mod passing_through;
pub mod red_split;
pub mod refine;
pub mod rules;
pub mod size;
pub mod step;
