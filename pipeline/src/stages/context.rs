//! Where a stage works, and how it tells what happens there.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use toml::Spanned;

use crate::error::{Error, Source};
use crate::observer::{Event, Observer, StagePlace};
use crate::state::Missing;

/// Where the stages of a run work, all of them alike.
#[derive(Clone, Copy)]
pub struct Workplace<'a> {
    /// What input paths are relative to.
    pub input_folder: &'a Path,
    /// Where output goes.
    pub output_folder: &'a Path,
    /// The config, for places in messages; none if the stages come from elsewhere.
    pub source: Option<&'a Source>,
    /// Whom to tell how far it is.
    pub observer: &'a dyn Observer,
    /// Whether to end as soon as possible.
    pub stop: &'a AtomicBool,
}

/// Where a stage works.
pub struct Context<'a> {
    /// As all stages of its run.
    pub work: Workplace<'a>,
    /// The stage.
    pub stage: StagePlace,
}

impl Context<'_> {
    /// Whether to end as soon as possible.
    pub fn asked_to_stop(&self) -> bool {
        self.work.stop.load(Ordering::Relaxed)
    }

    /// Tells the observer.
    pub fn tell(&self, event: Event) {
        self.work.observer.hear(&self.stage, &event);
    }

    /// Does one step, whose work returns its result and that result in words,
    /// and tells about its begin and its end.
    ///
    /// # Errors
    /// As the work.
    pub fn step<T, E>(
        &self,
        number: usize,
        of: usize,
        what: &str,
        work: impl FnOnce() -> Result<(T, String), E>,
    ) -> Result<T, E> {
        self.tell(Event::StepBegan { number, of, what: what.into() });
        let start = Instant::now();
        let (value, result) = work()?;
        let seconds = start.elapsed().as_secs_f64();
        self.tell(Event::StepDone { what: what.into(), result, seconds });
        Ok(value)
    }

    /// What an iteration asks: whether to end.
    pub(crate) fn go_on(&self) -> ControlFlow<()> {
        if self.asked_to_stop() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Tells what the user should know, quiet or not.
    pub(super) fn remark(&self, notes: &[String]) {
        notes.iter().for_each(|note| self.tell(Event::Remark(note.clone())));
    }

    /// An error about something this stage asks for.
    pub(crate) fn request(&self, message: String) -> Error {
        Error::Request { stage: self.stage.label.clone(), message }
    }

    /// An error about a name that the config gives and the mesh does not have.
    pub(super) fn name_error(&self, name: &Spanned<String>, message: &str) -> Error {
        match self.work.source {
            Some(source) => {
                let message = format!("stage `{}`: {message}", self.stage.label);
                Error::Name(source.error(&name.span(), message))
            }
            None => self.request(message.into()),
        }
    }

    /// An error of the solver, with what it was doing.
    pub(crate) fn solver(&self, what: &str, source: octruss_fem::Error) -> Error {
        Error::Solve { stage: self.stage.label.clone(), what: what.into(), source }
    }

    /// What the stages before should have made.
    ///
    /// # Errors
    /// That they have not.
    pub(super) fn needed<T>(&self, made: Result<T, Missing>) -> Result<T, Error> {
        made.map_err(|missing| Error::Order {
            stage: self.stage.label.clone(),
            needs: missing.stage,
        })
    }
}
