//! The commands: one file each, with its options and what it does.

mod basis;
mod compare;
mod convert;
mod info;
mod refine;
mod run;
mod spectrum;

pub use basis::Basis;
pub use compare::Compare;
pub use convert::Convert;
pub use info::Info;
pub use refine::Refine;
pub use run::Run;
pub use spectrum::Spectrum;
