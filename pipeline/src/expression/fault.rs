//! What is wrong with a text.

/// What is wrong at a byte of the text.
pub(super) struct Fault {
    pub(super) at: usize,
    pub(super) message: String,
}
