//! The command line: results on stdout, everything else on stderr.
//!
//! Exit codes: 0 good, 1 the run failed or an expectation was missed, 2 wrong
//! usage or config.

mod basis;
mod card;
mod compare;
mod comparison;
mod convert;
mod how_to_run;
mod info;
mod interrupt;
mod progress;
mod refine;
mod run;
mod sound_mesh;
mod spectrum;
mod traffic;
mod vertex_place;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};

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
    Run(run::Run),
    Compare(compare::Compare),
    Info(info::Info),
    Convert(convert::Convert),
    Refine(refine::Refine),
    Spectrum(spectrum::Spectrum),
    Basis(basis::Basis),
}

/// How many threads work.
#[derive(Args)]
struct Threads {
    /// Threads to work with; all of the machine's unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Threads {
    /// Does the work in a pool of its own if a number is given.
    fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> anyhow::Result<T> {
        let Some(threads) = self.threads else { return Ok(work()) };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build()?;
        Ok(pool.install(work))
    }
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

/// Prints a result. A reader that has gone away (`octruss info part.msh | head`)
/// is no failure.
fn print(text: &str) -> anyhow::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// Prints a message. Where stderr is closed there is nobody to tell.
fn say(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Prints an error; our messages contain those of their sources.
fn say_error(error: &anyhow::Error) {
    say(&format!("error: {error}"));
}
