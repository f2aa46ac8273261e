//! What the system says of this process' memory.

use anyhow::{Context, Result};
use std::fs;

/// Bytes in memory now.
pub fn resident() -> Result<usize> {
    entry("VmRSS:")
}

/// The most bytes that were in memory since [`forget_peak`].
pub fn peak() -> Result<usize> {
    entry("VmHWM:")
}

/// Makes the peak the memory in use now.
pub fn forget_peak() -> Result<()> {
    fs::write("/proc/self/clear_refs", "5").context("cannot reset the peak of memory (Linux only)")
}

fn entry(name: &str) -> Result<usize> {
    let status = fs::read_to_string("/proc/self/status").context("memory is told by Linux only")?;
    let line = status.lines().find_map(|line| line.strip_prefix(name));
    let kilobytes = line.and_then(|line| line.split_whitespace().next());
    let kilobytes = kilobytes.with_context(|| format!("no {name} in /proc/self/status"))?;
    Ok(1024 * kilobytes.parse::<usize>()?)
}
