//! `octruss compare`: prolongations, cycles and geometries side by side.

use std::path::{Path, PathBuf};

use octruss::{Recipe, comparison};

use crate::cli::display::Display;
use crate::cli::how_to_run::HowToRun;
use crate::cli::interrupt;
use crate::cli::say::{print, say};

/// Compare prolongations, cycles and geometries on the problem of a config
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
    octruss compare configs/prolongation-study-torus.toml\n  \
    octruss compare part.toml --set 'compare.prolongation=[\"box-spline\", \"linear\"]'\n\n\
    A table [compare] of the config lists what is varied: geometry, levels, prolongation,\n\
    affine-correction, interface-rows, coarse-operator, sweeps, smoother, repeats. Every list\n\
    goes with every other; without the table the prolongations of the first stage `solve` are\n\
    compared on both geometries and all levels. Tables, CSV, JSON and a picture go to\n\
    out/NAME as compare.txt, .csv, .json and .svg. Every solve is by conjugate gradients; the\n\
    stages import, check, subdivide and the first `solve` after them are looked at, other\n\
    stages and [expect] are not. Ctrl-C ends it without a table.")]
pub struct Compare {
    /// Config file
    #[arg(value_name = "CONFIG")]
    config: PathBuf,
    #[command(flatten)]
    how: HowToRun,
}

impl Compare {
    pub fn run(&self) -> anyhow::Result<()> {
        let recipe = Recipe::load(&self.config, &self.how.set).map_err(octruss::Error::from)?;
        let folder = self.how.out.clone().unwrap_or_else(|| Path::new("out").join(&recipe.name));
        octruss::output::check_folder(&folder)?;
        comparison::Comparison::remove_earlier(&folder)?;
        let stop = interrupt::flag()?;
        let display = Display::new(self.how.quiet);
        let compared =
            self.how.threads.install(|| comparison::compare(&recipe, &display, &stop))??;
        let files = compared.write(&folder)?;
        print(&compared.text())?;
        let files: Vec<String> = files.iter().map(|path| path.display().to_string()).collect();
        say(&format!("written: {}", files.join(", ")));
        Ok(())
    }
}
