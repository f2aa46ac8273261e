//! Workspaces that pieces of parallel work done by the same thread share.

use std::sync::{Mutex, PoisonError};

/// Workspaces that no thread works in. Which one a piece of work gets, and what an
/// earlier one left in it, must change nothing but the time.
///
/// (Rayon's `map_init` would make one for every piece of work that it splits off.)
pub struct Workspaces<W>(Mutex<Vec<W>>);

impl<W> Default for Workspaces<W> {
    /// None yet.
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

impl<W> Workspaces<W> {
    /// Lets `work` use an idle workspace, or a new one if there is none.
    pub fn lend<R>(&self, new: impl FnOnce() -> W, work: impl FnOnce(&mut W) -> R) -> R {
        let idle = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let taken = idle().pop();
        let mut workspace = taken.unwrap_or_else(new);
        let result = work(&mut workspace);
        idle().push(workspace);
        result
    }
}
