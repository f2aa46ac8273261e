//! The keys of a stage `solve`, sorted by what they are about.
//!
//! A config writes them side by side; the structs that take them are those of the
//! problem and the options of the library.

use octruss_base::choice::{Choice, Named};
use octruss_base::suggestion::suggestion;
use octruss_fem::Options;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::tree::Tree;
use crate::error::{ConfigError, Source};
use crate::options::option_names;
use crate::stages::{Equation, Solve};

type Table<'a> = DeTable<'a>;

/// Puts the keys of the options below `options`, those of the equation that `problem` names
/// below `problem`; all keep their places.
///
/// # Errors
/// An unknown equation, a key of another one, an unknown key.
pub fn sort_keys<'a>(
    mut table: Table<'a>,
    place: std::ops::Range<usize>,
    label: &str,
    source: &Source,
) -> Result<Table<'a>, ConfigError> {
    let (equation, named_at) = equation(&mut table, label, source)?;
    let own = option_names::<Solve>();
    let (mut rest, mut options, mut data) = (Table::new(), Table::new(), Table::new());
    for (key, value) in table {
        let name: &str = key.get_ref();
        let part = if equation.keys().contains(&name) {
            &mut data
        } else if option_names::<Options>().contains(&name) {
            &mut options
        } else if own.contains(&name) && name != OPTIONS {
            &mut rest
        } else {
            return Err(source.error(&key.span(), refusal(name, equation, label)));
        };
        part.insert(key, value);
    }
    let below =
        |name: &'static str, span: std::ops::Range<usize>, table: Table<'a>| -> (_, Tree<'a>) {
            (Spanned::new(span.clone(), name.into()), Spanned::new(span, DeValue::Table(table)))
        };
    let named_at = named_at.unwrap_or(place.clone());
    let (name, data) = below(equation.name(), named_at.clone(), data);
    let problem = below(PROBLEM, named_at, Table::from_iter([(name, data)]));
    rest.extend([problem, below(OPTIONS, place, options)]);
    Ok(rest)
}

const PROBLEM: &str = "problem";
const OPTIONS: &str = "options";

/// The equation that `problem` names, and where; usually Poisson's.
fn equation(
    table: &mut Table,
    label: &str,
    source: &Source,
) -> Result<(Equation, Option<std::ops::Range<usize>>), ConfigError> {
    let Some(problem) = table.remove(PROBLEM) else { return Ok((Equation::Poisson, None)) };
    let span = problem.span();
    let DeValue::String(name) = problem.get_ref() else {
        let found = problem.get_ref().type_str();
        let message = format!("`{PROBLEM}` in stage `{label}`: found {found}, expected a name");
        return Err(source.error(&span, message));
    };
    let Ok(Named(equation)) = name.parse() else {
        let valid: Vec<&str> = Equation::ALL.iter().map(|equation| equation.name()).collect();
        let message =
            format!("unknown value `{name}` in stage `{label}`{}", suggestion(name, &valid));
        return Err(source.error(&span, message));
    };
    Ok((equation, Some(span)))
}

/// Why a stage that solves this equation does not take a key.
fn refusal(key: &str, equation: Equation, label: &str) -> String {
    let owner = Equation::ALL.iter().find(|other| other.keys().contains(&key));
    if let Some(owner) = owner {
        let (owner, name) = (owner.name(), equation.name());
        let is_own = |key: &&&str| !Equation::ALL.iter().all(|other| other.keys().contains(*key));
        let own: Vec<&str> = equation.keys().iter().filter(is_own).copied().collect();
        return format!(
            "stage `{label}`: `{key}` belongs to problem = \"{owner}\", but this stage solves \
             \"{name}\" (keys of its own: {})",
            own.join(", ")
        );
    }
    let mut valid = vec![PROBLEM];
    let data = Equation::ALL.iter().flat_map(|equation| equation.keys());
    let own = option_names::<Solve>().iter().filter(|name| **name != OPTIONS);
    for name in data.chain(own).chain(option_names::<Options>()) {
        if !valid.contains(name) {
            valid.push(name);
        }
    }
    format!("unknown key `{key}` in stage `{label}`{}", suggestion(key, &valid))
}
