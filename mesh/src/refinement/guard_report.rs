//! What keeping the quality did to a refinement.

/// What the guard did in one step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GuardReport {
    /// The η that no tet falls below, unless its parent was below it.
    pub floor: f64,
    /// How many rows were pulled back.
    pub pulled_back: usize,
    /// How many of them all the way to the linear rule.
    pub linear: usize,
}
