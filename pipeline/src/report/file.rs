//! A report as a file.

use std::io::Write;
use std::path::Path;

use octruss_meshio::write_aside;

use super::run_report::{Report, SCHEMA};
use crate::error::Error;
use crate::output::{REPORT, create_folder};

impl Report {
    /// Writes `report.json` into a folder.
    ///
    /// # Errors
    /// If the folder cannot be made or the file not be written.
    pub fn write(&self, folder: &Path) -> Result<(), Error> {
        create_folder(folder)?;
        let text = serde_json::to_string_pretty(self).expect("a report has only string keys");
        write_aside(&folder.join(REPORT), |file| writeln!(file, "{text}"))?;
        Ok(())
    }

    /// Reads what [`Report::write`] wrote, also an earlier version of the same schema.
    ///
    /// # Errors
    /// A file that cannot be read, is no report, or has another schema.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let refused = |reason: String| Error::Report { path: path.into(), reason };
        let text = std::fs::read_to_string(path).map_err(|error| refused(error.to_string()))?;
        let report: serde_json::Value =
            serde_json::from_str(&text).map_err(|error| refused(error.to_string()))?;
        // Asked first: of another schema, whatever else is missing follows from it.
        match report["schema"].as_u64() {
            Some(schema) if schema == u64::from(SCHEMA) => {}
            Some(schema) => {
                return Err(refused(format!("it has schema {schema}, but {SCHEMA} is read here")));
            }
            None => return Err(refused("it is no report, for it has no `schema`".into())),
        }
        serde_json::from_str(&text).map_err(|error| refused(error.to_string()))
    }
}
