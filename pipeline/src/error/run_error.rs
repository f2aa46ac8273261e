//! Everything that can stop a run.

use std::path::PathBuf;

use octruss_mesh::CheckError;
use octruss_mesh::SubdivideError;

use super::config_error::ConfigError;
use super::order::needs_before;
use super::unfinished_solve::UnfinishedSolve;

/// Why a run stopped.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The config, or a part of it that only the run could check.
    #[error(transparent)]
    Config(#[from] ConfigError),
    /// A mesh file could not be read or written.
    #[error(transparent)]
    File(#[from] octruss_meshio::Error),
    /// The mesh has faults that refining and solving cannot live with.
    #[error("{}: {source}", path.display())]
    Unsound {
        /// The mesh file.
        path: PathBuf,
        /// The findings.
        source: CheckError,
    },
    /// A level could not be made.
    #[error("stage `{stage}`: {source}")]
    Subdivide {
        /// The stage's label.
        stage: String,
        /// What stopped it.
        source: SubdivideError,
    },
    /// The problem could not be solved.
    #[error("stage `{stage}`, {what}: {source}")]
    Solve {
        /// The stage's label.
        stage: String,
        /// What was being done, such as `linear prolongation`.
        what: String,
        /// What stopped it.
        source: octruss_fem::Error,
    },
    /// A solve did not reach its goal; its best iterate is kept.
    #[error(transparent)]
    Unfinished(Box<UnfinishedSolve>),
    /// The run was asked to stop between two stages.
    #[error("stopped on request before stage `{stage}`")]
    Stopped {
        /// The label of the stage that did not begin.
        stage: String,
    },
    /// A stage asks for something that its mesh or its levels do not offer.
    #[error("stage `{stage}`: {message}")]
    Request {
        /// The stage's label.
        stage: String,
        /// What was asked for, and what is there.
        message: String,
    },
    /// A name in the config that the mesh does not have.
    #[error(transparent)]
    Name(ConfigError),
    /// A stage stands before the one whose result it needs.
    #[error("{}", needs_before(&format!("stage `{stage}`"), needs))]
    Order {
        /// The stage's label.
        stage: String,
        /// The kind of stage that is missing.
        needs: &'static str,
    },
    /// A report could not be read back.
    #[error("cannot read the report {}: {reason}", path.display())]
    Report {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// The output folder cannot be made or written.
    #[error("cannot write to {}: {reason}", path.display())]
    Output {
        /// The folder or file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
}

impl Error {
    /// What a process should return: 2 for a wrong config, else 1.
    pub fn exit_code(&self) -> u8 {
        if matches!(self, Self::Config(_)) { 2 } else { 1 }
    }
}
