//! `octruss convert`: one mesh file into another.

use std::path::PathBuf;

use octruss_meshio::{Format, read, write};

/// Convert a mesh file into another format, sound or not
#[derive(clap::Args)]
#[command(after_help = "Formats by extension: reads .msh, .vtu, .vtk; writes .vtu, .vtk.\n\n\
    Example:\n  octruss convert part.msh part.vtu")]
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
        let format = Format::of(&self.output)?;
        let dataset = read(&self.input)?;
        for note in dataset.notes.iter().chain(&format.losses(&dataset)) {
            super::say(&format!("note: {note}"));
        }
        write(&self.output, &dataset)?;
        Ok(())
    }
}
