//! Wang's Loop-based scheme inside a solid (thesis, section 3.1.2); its interior
//! edges are halved.

use crate::neighbourhoods::Neighbourhoods;
use crate::subdivision_matrix::Row;

/// c itself, (1 − c)/m each of its m neighbours.
pub(crate) fn vertex(near: &Neighbourhoods, vertex: u32, c: f64, row: &mut Row) {
    row.add(vertex, c);
    let neighbours = near.neighbours(vertex);
    let each = (1.0 - c) / neighbours.clone().count() as f64;
    neighbours.for_each(|neighbour| row.add(neighbour, each));
}
