//! `$NodeData`, `$ElementData` and `$ElementNodeData`: a field of one time step.

use super::nodes::Nodes;
use super::scanner::Scanner;
use super::tags::TagMap;
use crate::dataset::{Field, Values};
use crate::problem::Problem;
use crate::text::quoted;

/// What the values belong to.
pub enum Target<'a> {
    /// Nodes; a value of an unknown one is an error.
    Nodes(&'a Nodes),
    /// Tets, by element tag; values of other elements are passed over.
    Tets(&'a TagMap, usize),
    /// The corners of tets, by element tag; values of other elements and at
    /// mid-side nodes are passed over.
    Corners(&'a TagMap, usize),
}

/// A field as one section gives it.
pub struct FieldStep {
    /// The values; NaN where the section has none.
    pub field: Field,
    /// The number of the time step.
    pub step: i64,
    /// How many nodes or tets there are.
    pub owners: usize,
    /// How many of them have no value.
    pub missing: usize,
}

/// What stands before the values.
struct DataHeader {
    name: String,
    step: i64,
    components: usize,
    entries: u64,
}

/// Reads the section; `None` if it has no value for any node or tet.
pub fn read(scanner: &mut Scanner, target: &Target) -> Result<Option<FieldStep>, Problem> {
    let header = header(scanner)?;
    let (owners, tuples) = match target {
        Target::Nodes(nodes) => (nodes.points.len(), 1),
        Target::Tets(_, count) => (*count, 1),
        Target::Corners(_, count) => (*count, 4),
    };
    let components = header.components;
    let width = components * tuples;
    let mut values = Vec::new();
    let mut given = Vec::new();
    let mut read = Vec::with_capacity(width);
    for _ in 0..header.entries {
        let index = index(scanner, target)?;
        let listed = tuples_listed(scanner, target, index)?;
        read.clear();
        for place in 0..listed {
            for _ in 0..components {
                let value = scanner.double("a value")?;
                if place < tuples as u64 {
                    read.push(value);
                }
            }
        }
        scanner.end_record("the values")?;
        if let Some(index) = index {
            values.resize(owners * width, f64::NAN);
            given.resize(owners, false);
            values[index * width..][..width].copy_from_slice(&read);
            given[index] = true;
        }
    }
    if given.is_empty() {
        return Ok(None);
    }
    let missing = given.iter().filter(|&&given| !given).count();
    let field = Field::new(header.name, components, Values::Float(values));
    Ok(Some(FieldStep { field, step: header.step, owners, missing }))
}

/// How many tuples an entry has: one, or as many as it says for the nodes of an
/// element, of which a tet has at least its corners.
fn tuples_listed(
    scanner: &mut Scanner,
    target: &Target,
    index: Option<usize>,
) -> Result<u64, Problem> {
    let Target::Corners(..) = target else { return Ok(1) };
    let place = scanner.position();
    let nodes = scanner.tag("the number of nodes of an element")?;
    if index.is_some() && nodes < 4 {
        return Err(scanner.malformed_at(
            place,
            format!("values at {nodes} nodes of a tet; expected at least its 4 corners"),
        ));
    }
    Ok(nodes)
}

fn index(scanner: &mut Scanner, target: &Target) -> Result<Option<usize>, Problem> {
    let place = scanner.position();
    let tag = scanner.tag("the tag that a value belongs to")?;
    Ok(match target {
        Target::Nodes(nodes) => Some(nodes.index(scanner, place, tag)? as usize),
        Target::Tets(map, _) | Target::Corners(map, _) => {
            map.index(tag).map(|index| index as usize)
        }
    })
}

/// Reads the three lists of tags, text in binary files, too: strings (the
/// field's name), real numbers (the time) and integers (step, components, entries).
fn header(scanner: &mut Scanner) -> Result<DataHeader, Problem> {
    let strings: u64 = scanner.number_line("the number of string tags")?;
    let mut name = None;
    for _ in 0..strings {
        let line = scanner.line("a string tag")?;
        let line = line.strip_prefix(b"\"").unwrap_or(line);
        let line = line.strip_suffix(b"\"").unwrap_or(line);
        name.get_or_insert_with(|| String::from_utf8_lossy(line).into_owned());
    }
    let reals: u64 = scanner.number_line("the number of real tags")?;
    for _ in 0..reals {
        scanner.number_line::<f64>("a real tag")?;
    }
    let place = scanner.position();
    let integers: u64 = scanner.number_line("the number of integer tags")?;
    if integers < 3 {
        return Err(scanner.malformed_at(
            place,
            format!("{integers} integer tags; expected at least 3: step, components, entries"),
        ));
    }
    let step = scanner.number_line("the time step")?;
    let components = components(scanner)?;
    let entries = scanner.number_line("the number of entries")?;
    for _ in 3..integers {
        scanner.number_line::<i64>("an integer tag")?;
    }
    Ok(DataHeader { name: name.unwrap_or_else(|| "unnamed".into()), step, components, entries })
}

fn components(scanner: &mut Scanner) -> Result<usize, Problem> {
    let place = scanner.position();
    let line = scanner.line("the number of components")?;
    match line {
        b"1" => Ok(1),
        b"3" => Ok(3),
        b"9" => Ok(9),
        _ => Err(scanner.malformed_at(
            place,
            format!(
                "found {} where the number of components was expected: 1, 3 or 9",
                quoted(line)
            ),
        )),
    }
}
