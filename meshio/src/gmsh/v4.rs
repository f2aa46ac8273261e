//! Nodes and elements of MSH 4.1: in blocks, each of one geometric entity.

use super::elements::{Elements, element_type, read_nodes};
use super::entities::Entities;
use super::nodes::{NodeList, Nodes};
use super::scanner::{Encoding, Scanner};
use crate::cell_kind::Simplex;
use crate::problem::Problem;

/// The first record of `$Nodes` or `$Elements`.
struct SectionHeader {
    blocks: u64,
    total: u64,
}

/// Reads `$Nodes`: in each block all tags, then all coordinates.
pub fn nodes(scanner: &mut Scanner) -> Result<Nodes, Problem> {
    let place = scanner.position();
    let header = section_header(scanner)?;
    let least = if scanner.encoding == Encoding::Ascii { 8 } else { 32 };
    scanner.announced(place, header.total, least, "nodes")?;
    let mut list = NodeList::default();
    for _ in 0..header.blocks {
        node_block(scanner, &mut list, least)?;
    }
    list.finish(scanner, header.total)
}

fn node_block(scanner: &mut Scanner, list: &mut NodeList, least: usize) -> Result<(), Problem> {
    let dimension = entity_dimension(scanner)?;
    scanner.int("the tag of an entity")?;
    let place = scanner.position();
    let parameters = match scanner.int("0 or 1 for parametric coordinates")? {
        0 => 0,
        1 => dimension,
        other => {
            return Err(scanner.malformed_at(
                place,
                format!("the mark for parametric coordinates is {other}; expected 0 or 1"),
            ));
        }
    };
    let place = scanner.position();
    let count = scanner.size("the number of nodes in a block")?;
    scanner.end_record("the start of the block")?;
    let count = scanner.announced(place, count, least, "nodes of a block")?;
    list.tags.reserve(count);
    list.places.reserve(count);
    list.points.reserve(count);
    for _ in 0..count {
        list.places.push(scanner.position());
        list.tags.push(scanner.size("a node tag")?);
        scanner.end_record("the node tag")?;
    }
    for _ in 0..count {
        let mut point = [0.0; 3];
        for coordinate in &mut point {
            *coordinate = scanner.double("a coordinate of a node")?;
        }
        for _ in 0..parameters {
            scanner.double("a parametric coordinate of a node")?;
        }
        list.points.push(point);
        scanner.end_record("the node")?;
    }
    Ok(())
}

/// Reads `$Elements`.
pub fn elements(
    scanner: &mut Scanner,
    nodes: &Nodes,
    entities: &Entities,
) -> Result<Elements, Problem> {
    let header = section_header(scanner)?;
    let mut elements = Elements::default();
    let mut total = 0;
    for _ in 0..header.blocks {
        total += element_block(scanner, nodes, entities, &mut elements)?;
    }
    if total != header.total {
        return Err(scanner.malformed(format!(
            "{} elements are announced, but the blocks hold {total}; expected the same number",
            header.total
        )));
    }
    Ok(elements)
}

/// Returns the number of elements in the block.
fn element_block(
    scanner: &mut Scanner,
    nodes: &Nodes,
    entities: &Entities,
    elements: &mut Elements,
) -> Result<u64, Problem> {
    let dimension = entity_dimension(scanner)?;
    let groups = entities.groups(dimension, scanner.int("the tag of an entity")?);
    let place = scanner.position();
    let code = scanner.int("an element type")?;
    let kind = element_type(scanner, place, code)?;
    let place = scanner.position();
    let count = scanner.size("the number of elements in a block")?;
    scanner.end_record("the start of the block")?;
    let least = if scanner.encoding == Encoding::Ascii { 2 } else { 8 } * (1 + kind.nodes);
    let room = scanner.announced(place, count, least - 1, "elements of a block")?;
    if kind.simplex == Some(Simplex::Tet) {
        elements.reserve_tets(room);
    }
    let mut numbers = Vec::with_capacity(kind.nodes);
    for _ in 0..count {
        let tag = scanner.size("an element tag")?;
        read_nodes(scanner, nodes, kind, |scanner| scanner.size("a node tag"), &mut numbers)?;
        elements.add(kind, tag, &numbers, groups);
    }
    Ok(count)
}

fn entity_dimension(scanner: &mut Scanner) -> Result<i32, Problem> {
    let place = scanner.position();
    let dimension = scanner.int("the dimension of an entity")?;
    if (0..=3).contains(&dimension) {
        return Ok(dimension);
    }
    Err(scanner
        .malformed_at(place, format!("the dimension of an entity is {dimension}; expected 0 to 3")))
}

fn section_header(scanner: &mut Scanner) -> Result<SectionHeader, Problem> {
    let blocks = scanner.size("the number of blocks")?;
    let total = scanner.size("the total number")?;
    scanner.size("the smallest tag")?;
    scanner.size("the largest tag")?;
    scanner.end_record("the start of the section")?;
    Ok(SectionHeader { blocks, total })
}
