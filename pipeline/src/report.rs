//! What a run did, as `report.json` tells it. The names of the keys are a
//! promise to scripts.

use serde::Serialize;
use serde_json::Value;

use crate::error::UnfinishedSolve;
use crate::recipe::Outcome;
use crate::stages::Done;

/// A whole run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
    /// The version of the program.
    pub octruss: &'static str,
    /// The recipe's name.
    pub config: String,
    /// How many threads worked.
    pub threads: usize,
    /// Wall time of all stages.
    pub seconds: f64,
    /// The process's greatest resident size up to the end of this run; null
    /// where the system does not tell.
    pub peak_memory_bytes: Option<u64>,
    /// In the order in which they ran.
    pub stages: Vec<StageReport>,
    /// What was expected, with what was measured; empty of a run that did not finish.
    pub expectations: Vec<Outcome>,
    /// The solve that did not reach its goal, if one did not; `stages` are those
    /// before it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unfinished: Option<UnfinishedSolve>,
}

/// What one stage did.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StageReport {
    /// The stage's label, see [`crate::recipe::stage_labels`].
    pub name: String,
    /// Wall time.
    pub seconds: f64,
    /// The rest depends on the stage.
    #[serde(flatten)]
    pub done: Done,
}

impl Report {
    /// Every single number of the report by the name that expectations use:
    /// keys joined by dots; a list of named things contributes their names,
    /// a list of unnamed ones numbers from 0. So `seconds`,
    /// `subdivide.levels.3.tets`, `solve.box-spline.iterations`. Lists of bare
    /// numbers and the expectations themselves are left out.
    pub fn numbers(&self) -> Vec<(String, f64)> {
        let mut tree = serde_json::to_value(self).expect("a report has only string keys");
        if let Value::Object(keys) = &mut tree {
            keys.remove("expectations");
        }
        let mut numbers = Vec::new();
        collect(&tree, "", &mut numbers);
        numbers
    }
}

fn collect(tree: &Value, path: &str, numbers: &mut Vec<(String, f64)>) {
    match tree {
        Value::Number(number) => {
            numbers.push((path.into(), number.as_f64().unwrap_or(f64::NAN)));
        }
        Value::Object(keys) => {
            for (key, value) in keys {
                // Things that have names hang directly below their owner.
                let below = if has_names(value) { path.into() } else { join(path, key) };
                collect(value, &below, numbers);
            }
        }
        Value::Array(entries) => {
            for (index, entry) in entries.iter().enumerate().filter(|(_, e)| e.is_object()) {
                let name = entry["name"].as_str().map_or_else(|| index.to_string(), String::from);
                collect(entry, &join(path, &name), numbers);
            }
        }
        _ => {}
    }
}

fn has_names(value: &Value) -> bool {
    value.as_array().is_some_and(|entries| entries.iter().any(|entry| entry["name"].is_string()))
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.into() } else { format!("{path}.{name}") }
}
