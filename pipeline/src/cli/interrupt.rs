//! Ctrl-C: the first asks to stop, the second ends the process at once.

use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::say::say;

/// What shells say of a process that Ctrl-C ended.
const INTERRUPTED: i32 = 130;

/// Takes over Ctrl-C for the rest of the process; the first one sets the flag.
pub fn flag() -> anyhow::Result<Arc<AtomicBool>> {
    let flag = Arc::new(AtomicBool::new(false));
    let set = Arc::clone(&flag);
    ctrlc::set_handler(move || {
        if set.swap(true, Ordering::Relaxed) {
            process::exit(INTERRUPTED);
        }
        say("stopping after this step, a solve after this iteration; again to end at once");
    })?;
    Ok(flag)
}
