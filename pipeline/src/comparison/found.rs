//! What a comparison found, and its files.

use std::io::Write;
use std::path::{Path, PathBuf};

use octruss_meshio::write_aside;
use serde::{Deserialize, Serialize};

use super::carried_solution::CarriedSolution;
use super::row::Row;
use super::text;
use crate::error::Error;
use crate::output;

/// What a comparison writes.
const FILES: [&str; 4] = ["compare.txt", "compare.csv", "compare.json", "compare.svg"];

/// What a comparison found. Its keys in `compare.json` are no promise yet, so it has no
/// number of a schema.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// The version that made it.
    pub octruss: String,
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
    pub carried: Vec<CarriedSolution>,
}

impl Comparison {
    /// The table for people, Chang's test below it, and the verdict.
    pub fn text(&self) -> String {
        text::text(&self.rows, &self.carried, &self.verdict)
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
            super::picture::svg(&self.rows),
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
