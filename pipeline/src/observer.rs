//! What happens in a run, for whoever wants to show it.

/// Which stage something happens in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StagePlace {
    /// The stage's number, from 1.
    pub number: usize,
    /// How many stages the run has.
    pub of: usize,
    /// What the stage is called, see [`crate::recipe::stage_labels`].
    pub label: String,
}

/// What just happened in a stage.
#[derive(Debug, Clone, PartialEq)]
pub enum Event {
    /// The stage begins.
    StageBegan,
    /// A step of the stage begins.
    StepBegan {
        /// The step's number, from 1.
        number: usize,
        /// How many steps the stage has.
        of: usize,
        /// What is done, such as `level 2 of 3`.
        what: String,
    },
    /// Something that the user should know even if progress is of no interest.
    Remark(String),
    /// Something worth showing while a step runs, such as a residual.
    Note(String),
    /// The step is done.
    StepDone {
        /// As when it began.
        what: String,
        /// What came of it, such as `1.6 M tets`.
        result: String,
        /// How long it took.
        seconds: f64,
    },
    /// The stage is done.
    StageDone {
        /// The stage in a sentence.
        summary: String,
        /// How long it took.
        seconds: f64,
    },
}

/// Who is told what happens in a run, from whatever thread it happens in. A closure
/// is one.
///
/// ```
/// use octruss::observer::{Event, StagePlace};
/// let observer = |stage: &StagePlace, event: &Event| {
///     if let Event::StageDone { summary, .. } = event {
///         println!("[{}/{}] {}: {summary}", stage.number, stage.of, stage.label);
///     }
/// };
/// # fn takes(_: &dyn octruss::Observer) {}
/// # takes(&observer);
/// ```
pub trait Observer: Sync {
    /// Hears of one event.
    fn hear(&self, stage: &StagePlace, event: &Event);
}

impl<F: Fn(&StagePlace, &Event) + Sync> Observer for F {
    fn hear(&self, stage: &StagePlace, event: &Event) {
        self(stage, event);
    }
}
