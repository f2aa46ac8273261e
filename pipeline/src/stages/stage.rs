//! The kinds of stages.

use serde::Deserialize;

use super::check::Check;
use super::context::Context;
use super::import::Import;
use super::solve::keys::Solve;
use super::stage_contradiction::StageContradiction;
use super::subdivide::Subdivide;
use super::write::Write;
use crate::error::Error;
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
    pub fn contradiction(&self) -> Option<StageContradiction> {
        match self {
            Self::Subdivide(options) => options.contradiction().map(StageContradiction::of_stage),
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
