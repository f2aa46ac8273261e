//! `octruss info`: a mesh file in numbers.

use std::path::PathBuf;

use crate::cli::card::card;
use crate::cli::say::print;

/// Show what a mesh file holds, sound or not: counts, groups, quality, findings
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  octruss info part.msh\n  \
    octruss info part.msh --json | jq .quality.eta_min")]
pub struct Info {
    /// Mesh to read: .msh, .vtu, .vtk or .mesh
    mesh: PathBuf,
    /// Print JSON for scripts
    #[arg(long)]
    json: bool,
}

impl Info {
    pub fn run(&self) -> anyhow::Result<()> {
        let description = octruss::describe(&octruss_meshio::read(&self.mesh)?);
        if self.json {
            return print(&(serde_json::to_string_pretty(&description)? + "\n"));
        }
        print(&card(&self.mesh, &description))
    }
}
