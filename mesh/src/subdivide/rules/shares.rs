//! Shares that several rules give alike.

use crate::refinement::subdivision_matrix::Row;
use crate::subdivide::neighbourhoods::Neighbourhoods;

/// The weight `own` for a vertex of the solid, the rest shared by its neighbours.
pub(super) fn add_own_and_neighbours(near: &Neighbourhoods, vertex: u32, own: f64, row: &mut Row) {
    let neighbours = near.neighbours(vertex);
    let each = (1.0 - own) / neighbours.clone().count() as f64;
    let lower = neighbours.clone().take_while(|&other| other < vertex);
    lower.for_each(|neighbour| row.add(neighbour, each));
    row.add(vertex, own);
    let higher = neighbours.skip_while(|&other| other < vertex);
    higher.for_each(|neighbour| row.add(neighbour, each));
}

/// The mean of the ends of an edge.
pub(super) fn midpoint(near: &Neighbourhoods, edge: u32, row: &mut Row) {
    add_ends(near, edge, 0.5, row);
}

/// The same weight for both ends of an edge.
pub(super) fn add_ends(near: &Neighbourhoods, edge: u32, weight: f64, row: &mut Row) {
    near.ends(edge).into_iter().for_each(|end| row.add(end, weight));
}
