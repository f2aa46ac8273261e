//! What all commands that run a config take beside it.

use std::path::PathBuf;

use super::threads::Threads;

/// Where output goes, what is replaced, and how to work.
#[derive(clap::Args)]
pub struct HowToRun {
    /// Where output goes [default: out/NAME]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace one value of a config; may be repeated
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    #[command(flatten)]
    pub threads: Threads,
    /// No progress on stderr; notes and errors stay
    #[arg(long)]
    pub quiet: bool,
}
