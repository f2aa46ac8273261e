//! `--threads`.

use clap::Args;

/// How many threads work.
#[derive(Args)]
pub struct Threads {
    /// Threads to work with; all of the machine's unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Threads {
    /// Does the work in a pool of its own if a number is given.
    pub fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> anyhow::Result<T> {
        let Some(threads) = self.threads else { return Ok(work()) };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build()?;
        Ok(pool.install(work))
    }
}
