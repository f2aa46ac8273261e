//! Wang's Loop-based scheme inside a solid (thesis, section 3.1.2); its interior
//! edges are halved.

use super::shares::add_own_and_neighbours;
use crate::refinement::subdivision_matrix::Row;
use crate::subdivide::neighbourhoods::Neighbourhoods;

/// c itself, (1 − c)/m each of its m neighbours.
pub(crate) fn vertex(near: &Neighbourhoods, vertex: u32, c: f64, row: &mut Row) {
    add_own_and_neighbours(near, vertex, c, row);
}
