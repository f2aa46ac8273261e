//! The steps of a run: one file each, with its options, what it does and what
//! it reports.

mod check;
mod contradiction;
mod corner_fields;
mod field_notes;
mod groups;
mod import;
mod jumps;
pub(crate) mod solve;
mod stale;
mod subdivide;
mod write;

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use serde::Deserialize;
use toml::Spanned;

pub use check::Check;
pub use contradiction::{Contradiction, Where};
pub use import::Import;
pub use solve::biharmonic::BiharmonicKeys;
pub use solve::elasticity::ElasticityKeys;
pub use solve::fixed::Fixed;
pub use solve::poisson::PoissonKeys;
pub use solve::problem::{Equation, Problem};
pub use solve::stage::Solve;
pub use subdivide::Subdivide;
pub use write::Write;

use crate::error::{Error, Source};
use crate::mesh_phase::Missing;
use crate::observer::{Event, Observer, StagePlace};
use crate::report::Done;
use crate::state::State;

/// One step with its options.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stage {
    /// Reads a mesh file.
    Import(Import),
    /// Refuses or repairs an unsound mesh.
    Check(Check),
    /// Refines the mesh.
    Subdivide(Subdivide),
    /// Solves a problem on the finest mesh.
    Solve(Box<Solve>),
    /// Writes meshes and fields for ParaView.
    Write(Write),
}

/// Where a stage works.
pub struct Context<'a> {
    /// What input paths are relative to.
    pub input_folder: &'a Path,
    /// Where output goes.
    pub output_folder: &'a Path,
    /// The config, for places in messages; none if the stages come from elsewhere.
    pub source: Option<&'a Source>,
    /// The stage.
    pub stage: StagePlace,
    /// Whom to tell how far it is.
    pub observer: &'a dyn Observer,
    /// Whether to end as soon as possible.
    pub stop: &'a AtomicBool,
}

impl Context<'_> {
    /// Whether to end as soon as possible.
    pub fn asked_to_stop(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Tells the observer.
    pub fn tell(&self, event: Event) {
        self.observer.hear(&self.stage, &event);
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
    fn remark(&self, notes: &[String]) {
        notes.iter().for_each(|note| self.tell(Event::Remark(note.clone())));
    }

    /// An error about something this stage asks for.
    fn request(&self, message: String) -> Error {
        Error::Request { stage: self.stage.label.clone(), message }
    }

    /// An error about a name that the config gives and the mesh does not have.
    fn name_error(&self, name: &Spanned<String>, message: &str) -> Error {
        let message = format!("stage `{}`: {message}", self.stage.label);
        match self.source {
            Some(source) => Error::Name(source.error(&name.span(), message)),
            None => self.request(message),
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
    fn needed<T>(&self, made: Result<T, Missing>) -> Result<T, Error> {
        made.map_err(|missing| Error::Order {
            stage: self.stage.label.clone(),
            needs: missing.stage,
        })
    }
}

impl Stage {
    /// Every kind, as configs call it.
    pub const KINDS: [&'static str; 5] = ["import", "check", "subdivide", "solve", "write"];

    /// The kind, as configs call it.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Import(_) => "import",
            Self::Check(_) => "check",
            Self::Subdivide(_) => "subdivide",
            Self::Solve(_) => "solve",
            Self::Write(_) => "write",
        }
    }

    /// The kind of stage whose result this one works on.
    pub fn needs(&self) -> Option<&'static str> {
        match self {
            Self::Import(_) => None,
            Self::Check(_) => Some("import"),
            Self::Subdivide(_) | Self::Solve(_) | Self::Write(_) => Some("check"),
        }
    }

    /// What in the options does not go together, if anything.
    pub fn contradiction(&self) -> Option<Contradiction> {
        match self {
            Self::Subdivide(options) => options.contradiction().map(Contradiction::of_stage),
            Self::Solve(options) => options.contradiction(),
            _ => None,
        }
    }

    /// Does it.
    ///
    /// # Errors
    /// Whatever stops the stage; the state is then not to be used further.
    pub fn run(&self, state: &mut State, context: &Context) -> Result<Done, Error> {
        match self {
            Self::Import(options) => options.run(state, context).map(Done::Import),
            Self::Check(options) => options.run(state, context).map(Done::Check),
            Self::Subdivide(options) => {
                options.run(state, context).map(|report| Done::Subdivide(Box::new(report)))
            }
            Self::Solve(options) => options.run(state, context).map(Done::Solve),
            Self::Write(options) => options.run(state, context).map(Done::Write),
        }
    }
}
