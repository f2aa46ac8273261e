//! Everything that can stop a run, with places in the config where that is to blame.

mod config_error;
mod order;
mod run_error;
mod source;
mod unfinished_solve;

pub use config_error::{ConfigError, ConfigPlace};
pub(crate) use order::needs_before;
pub use run_error::Error;
pub use source::{Override, Source};
pub use unfinished_solve::UnfinishedSolve;
