//! `octruss run`: configs, one after the other.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

use octruss::error::{ConfigError, ConfigPlace};
use octruss::{Error, Recipe, Report, amount};

use crate::cli::display::Display;
use crate::cli::how_to_run::HowToRun;
use crate::cli::say::{print, say, say_error};
use crate::cli::{interrupt, solve_table, traffic_table};

/// Run configs: import, check, subdivide, solve, write, compare with what is expected
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
    octruss run configs/quickstart.toml\n  \
    octruss run configs/*.toml --out results --threads 4\n  \
    octruss run configs/quickstart.toml --set stage.subdivide.levels=1 --set expect={}\n\n\
    A key of --set is a path of names joined by dots. A stage goes by its kind (the second\n\
    solve by `solve-2`), entries of other lists by their number from 0. Report and files go\n\
    to out/NAME, or with --out DIR to DIR, with several configs to DIR/NAME. Ctrl-C ends a\n\
    solve between iterations and keeps its iterate as unfinished.vtu; a second one ends at once.")]
pub struct Run {
    /// Config files
    #[arg(required = true, value_name = "CONFIG")]
    configs: Vec<PathBuf>,
    #[command(flatten)]
    how: HowToRun,
}

impl Run {
    pub fn run(&self) -> anyhow::Result<ExitCode> {
        // All configs are read before any runs: a slip in the last is told at once.
        let recipes = self.recipes()?;
        let mut summary = Vec::new();
        let mut worst = 0;
        let stop = interrupt::flag()?;
        for recipe in &recipes {
            if stop.load(Ordering::Relaxed) {
                summary.push(format!("{}: not run\n", recipe.name));
                worst = worst.max(1);
                continue;
            }
            let folder = self.output_folder(&recipe.name);
            if recipes.len() > 1 && !self.how.quiet {
                say(&format!("── {} ──", recipe.name));
            }
            let outcome = self.how.threads.install(|| self.run_one(recipe, &folder, &stop))?;
            let (code, words) = match outcome {
                Ok(report) => conclude(&report)?,
                Err(error) => {
                    let code = error.exit_code();
                    say_error(&error.into());
                    (code, "failed".into())
                }
            };
            worst = worst.max(code);
            summary.push(format!("{}: {words} → {}\n", recipe.name, folder.display()));
        }
        print(&summary.concat())?;
        Ok(ExitCode::from(worst))
    }

    fn recipes(&self) -> Result<Vec<Recipe>, Error> {
        let load = |path: &PathBuf| Recipe::load(path, &self.how.set).map_err(Error::from);
        let recipes: Vec<Recipe> = self.configs.iter().map(load).collect::<Result<_, _>>()?;
        for (index, recipe) in recipes.iter().enumerate() {
            if recipes[..index].iter().any(|before| before.name == recipe.name) {
                let message = format!("another config is called `{}`, too", recipe.name);
                let place = ConfigPlace::File(self.configs[index].clone());
                return Err(ConfigError { place, message }.into());
            }
        }
        Ok(recipes)
    }

    fn output_folder(&self, name: &str) -> PathBuf {
        match &self.how.out {
            Some(folder) if self.configs.len() == 1 => folder.clone(),
            Some(folder) => folder.join(name),
            None => Path::new("out").join(name),
        }
    }

    fn run_one(&self, recipe: &Recipe, folder: &Path, stop: &AtomicBool) -> Result<Report, Error> {
        octruss::run(recipe, folder, &Display::new(self.how.quiet), stop)
    }
}

/// Prints what a run found; tells how it went, as exit code and in words.
fn conclude(report: &Report) -> anyhow::Result<(u8, String)> {
    print(&solve_table::of_solves(report))?;
    print(&traffic_table::of_solves(report))?;
    let missed: Vec<_> = report.expectations.iter().filter(|outcome| !outcome.met).collect();
    for outcome in &missed {
        say(&format!("error: expectation missed: {outcome}"));
    }
    let memory = report
        .peak_memory_bytes
        .map_or_else(String::new, |bytes| format!(", at most {} of memory", amount::bytes(bytes)));
    let expected = match (missed.len(), report.expectations.len()) {
        (_, 0) => String::new(),
        (0, all) => format!(", expectations met: all {all}"),
        (some, all) => format!(", expectations missed: {some} of {all}"),
    };
    let code = u8::from(!missed.is_empty());
    let verdict = if code == 0 { "good" } else { "failed" };
    Ok((code, format!("{verdict} in {:.1} s{memory}{expected}", report.seconds)))
}
