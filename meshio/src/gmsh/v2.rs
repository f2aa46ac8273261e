//! Nodes and elements of MSH 2.2: each element carries its tags.

use super::elements::{Elements, element_type, read_nodes};
use super::nodes::{NodeList, Nodes};
use super::scanner::{Encoding, Scanner};
use crate::problem::Problem;

/// Reads `$Nodes`: tag and three coordinates each.
pub fn nodes(scanner: &mut Scanner) -> Result<Nodes, Problem> {
    let place = scanner.position();
    let count: u64 = scanner.number_line("the number of nodes")?;
    let least = if scanner.encoding == Encoding::Ascii { 8 } else { 28 };
    let capacity = scanner.announced(place, count, least, "nodes")?;
    let mut list = NodeList {
        tags: Vec::with_capacity(capacity),
        points: Vec::with_capacity(capacity),
        places: Vec::with_capacity(capacity),
    };
    for _ in 0..count {
        list.places.push(scanner.position());
        list.tags.push(scanner.tag("a node tag")?);
        let mut point = [0.0; 3];
        for coordinate in &mut point {
            *coordinate = scanner.double("a coordinate of a node")?;
        }
        list.points.push(point);
        scanner.end_record("the node")?;
    }
    list.finish(scanner, count)
}

/// Reads `$Elements`. Binary files group the elements under headers, text has one a line.
pub fn elements(scanner: &mut Scanner, nodes: &Nodes) -> Result<Elements, Problem> {
    let place = scanner.position();
    let count: u64 = scanner.number_line("the number of elements")?;
    let room = scanner.announced(place, count, 8, "elements")?;
    let mut elements = Elements::default();
    // Most elements of a volume mesh are tets.
    elements.reserve_tets(room);
    if scanner.encoding == Encoding::Ascii {
        ascii_elements(scanner, nodes, count, &mut elements)?;
    } else {
        binary_elements(scanner, nodes, count, &mut elements)?;
    }
    Ok(elements)
}

fn ascii_elements(
    scanner: &mut Scanner,
    nodes: &Nodes,
    count: u64,
    elements: &mut Elements,
) -> Result<(), Problem> {
    let mut numbers = Vec::new();
    for _ in 0..count {
        let tag = scanner.tag("an element tag")?;
        let place = scanner.position();
        let code = scanner.int("an element type")?;
        let kind = element_type(scanner, place, code)?;
        let tags = scanner.tag("the number of tags")?;
        let group = physical_group(scanner, tags)?;
        read_nodes(scanner, nodes, kind, node_tag, &mut numbers)?;
        elements.add_or_merge(kind, tag, &numbers, group);
    }
    Ok(())
}

fn binary_elements(
    scanner: &mut Scanner,
    nodes: &Nodes,
    count: u64,
    elements: &mut Elements,
) -> Result<(), Problem> {
    let mut numbers = Vec::new();
    let mut read = 0;
    while read < count {
        let place = scanner.position();
        let code = scanner.int("an element type")?;
        let kind = element_type(scanner, place, code)?;
        let place = scanner.position();
        let following = scanner.tag("the number of elements in a block")?;
        if following == 0 || following > count - read {
            return Err(scanner.malformed_at(
                place,
                format!(
                    "a block announces {following} elements where {} are left of {count}; \
                     expected 1 to as many as are left",
                    count - read
                ),
            ));
        }
        let tags = scanner.tag("the number of tags")?;
        for _ in 0..following {
            let tag = scanner.tag("an element tag")?;
            let group = physical_group(scanner, tags)?;
            read_nodes(scanner, nodes, kind, node_tag, &mut numbers)?;
            elements.add_or_merge(kind, tag, &numbers, group);
        }
        read += following;
    }
    Ok(())
}

/// The first of an element's tags is its group, 0 for none; the others
/// (geometric entity, partitions) are not needed.
fn physical_group(scanner: &mut Scanner, tags: u64) -> Result<i32, Problem> {
    let mut group = 0;
    for index in 0..tags {
        let tag = scanner.int("a tag of an element")?;
        if index == 0 {
            group = tag;
        }
    }
    Ok(group)
}

#[inline]
fn node_tag(scanner: &mut Scanner) -> Result<u64, Problem> {
    scanner.tag("a node tag")
}
