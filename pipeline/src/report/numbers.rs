//! The numbers of a report by their names.

use serde_json::Value;

use super::run_report::Report;

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
