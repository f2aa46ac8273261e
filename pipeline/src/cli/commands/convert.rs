//! `octruss convert`: one mesh file into another.

use std::path::PathBuf;

use octruss::output::write_with_surfaces;
use octruss_meshio::{check_target, read};

use crate::cli::say::say;

/// Convert a mesh file into another format, sound or not
#[derive(clap::Args)]
#[command(
    after_help = "Formats by extension: reads .msh, .vtu, .vtk, .mesh; writes .vtu, .vtk, .mesh.\n\
    Tagged surfaces go beside a .vtu, as NAME.surfaces.vtu.\n\n\
    Example:\n  octruss convert part.msh part.vtu"
)]
pub struct Convert {
    /// Mesh to read
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// File to write
    #[arg(value_name = "OUT")]
    output: PathBuf,
}

impl Convert {
    pub fn run(&self) -> anyhow::Result<()> {
        // Asked first: reading may take long.
        let format = check_target(&self.output)?;
        let dataset = read(&self.input)?;
        for note in dataset.notes.iter().chain(&format.losses(&dataset)) {
            say(&format!("note: {note}"));
        }
        write_with_surfaces(&self.output, &dataset)?;
        Ok(())
    }
}
