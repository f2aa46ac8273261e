//! The convergence study as a product: prolongations, cycles and geometries on one
//! problem, side by side.
//!
//! ```text
//! Recipe ─▶ Plan ─▶ for each geometry and level: Variants ─▶ Rows ─▶ Verdict
//!                                           └─▶ Carried (a coarse solution, interpolated)
//! ```

mod attempt;
mod carried;
#[cfg(feature = "pictures")]
mod picture;
mod plan;
mod row;
mod study;
mod text;
mod verdict;

use std::io::Write;
use std::path::{Path, PathBuf};

use octruss_meshio::write_aside;
use serde::Serialize;

pub use carried::Carried;
pub use row::Row;
pub use study::compare;

use crate::error::Error;
use crate::output;

/// What a comparison writes.
const FILES: [&str; 4] = ["compare.txt", "compare.csv", "compare.json", "compare.svg"];

/// What a comparison found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// The version that made it.
    pub octruss: &'static str,
    /// The config's name.
    pub config: String,
    /// How many threads worked.
    pub threads: usize,
    /// Wall-clock time of everything.
    pub seconds: f64,
    /// What the numbers say, in a sentence for each geometry.
    pub verdict: Vec<String>,
    /// One a variant, by geometry and level.
    pub rows: Vec<Row>,
    /// Solutions of coarse levels on the next finer one.
    pub carried: Vec<Carried>,
}

impl Comparison {
    /// The table for people, Chang's test below it, and the verdict.
    pub fn text(&self) -> String {
        text::text(self)
    }

    /// Removes what [`Comparison::write`] wrote before, so that nothing is taken for the
    /// comparison of now.
    ///
    /// # Errors
    /// If the system does not let a file go.
    pub fn remove_earlier(folder: &Path) -> Result<(), Error> {
        output::remove(folder, &FILES)
    }

    /// Writes `compare.txt`, `compare.csv`, `compare.json` and `compare.svg`, the last
    /// with the feature `pictures` alone; returns the files.
    ///
    /// # Errors
    /// If the folder cannot be made or a file not be written.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, Error> {
        output::create_folder(folder)?;
        let json = serde_json::to_string_pretty(self).expect("a comparison has only string keys");
        let contents = [
            self.text(),
            text::csv(&self.rows),
            json + "\n",
            #[cfg(feature = "pictures")]
            picture::svg(&self.rows),
        ];
        let mut paths = Vec::new();
        for (name, content) in FILES.into_iter().zip(contents) {
            let path = folder.join(name);
            write_aside(&path, |file| file.write_all(content.as_bytes()))?;
            paths.push(path);
        }
        Ok(paths)
    }
}
