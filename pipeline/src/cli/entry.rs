//! Where the command begins: which of its commands is meant, and the exit code.

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use super::commands;
use super::say::say_error;

#[derive(Parser)]
#[command(
    version,
    about = "Solid subdivision and multigrid for tetrahedral finite-element meshes",
    after_help = "Examples:\n  \
        octruss run configs/quickstart.toml\n  \
        octruss info examples/meshes/bracket.msh\n  \
        octruss refine part.msh part.vtu --scheme box-spline --levels 2\n\n\
        Exit codes: 0 good, 1 the run failed or an expectation was missed, \
        2 wrong usage or config."
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Run(commands::Run),
    Compare(commands::Compare),
    Info(commands::Info),
    Convert(commands::Convert),
    Refine(commands::Refine),
    Spectrum(commands::Spectrum),
    Basis(commands::Basis),
}

/// Parses the command line and does what it says.
pub fn main() -> ExitCode {
    let cli = Cli::parse();
    let outcome = match &cli.command {
        Command::Run(options) => options.run(),
        Command::Compare(options) => options.run().map(|()| ExitCode::SUCCESS),
        Command::Info(options) => options.run().map(|()| ExitCode::SUCCESS),
        Command::Convert(options) => options.run().map(|()| ExitCode::SUCCESS),
        Command::Refine(options) => options.run().map(|()| ExitCode::SUCCESS),
        Command::Spectrum(options) => options.run().map(|()| ExitCode::SUCCESS),
        Command::Basis(options) => options.run().map(|()| ExitCode::SUCCESS),
    };
    outcome.unwrap_or_else(|error| {
        say_error(&error);
        ExitCode::from(exit_code(&error))
    })
}

/// 2 for a wrong config, else 1.
fn exit_code(error: &anyhow::Error) -> u8 {
    error.downcast_ref::<octruss::Error>().map_or(1, octruss::Error::exit_code)
}
