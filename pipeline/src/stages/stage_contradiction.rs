//! Options that do not go together.

use std::ops::Range;

/// What does not go together, and where the config says so.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StageContradiction {
    /// Where.
    pub place: Where,
    /// What, and what to do.
    pub message: String,
}

/// A place in a stage of a config.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Where {
    /// The stage as a whole.
    Stage,
    /// The key of this name.
    Key(&'static str),
    /// A part of the text.
    Span(Range<usize>),
}

impl StageContradiction {
    /// About the stage as a whole.
    pub(super) fn of_stage(message: String) -> Self {
        Self { place: Where::Stage, message }
    }

    /// About a key.
    pub(super) fn of_key(key: &'static str, message: String) -> Self {
        Self { place: Where::Key(key), message }
    }

    /// About a part of the text.
    pub(super) fn at(span: Range<usize>, message: String) -> Self {
        Self { place: Where::Span(span), message }
    }
}
