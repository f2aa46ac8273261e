//! The box-spline scheme inside a solid (Chang's thesis, section 4.5).

use super::shares::add_own_and_neighbours;
use crate::refinement::subdivision_matrix::Row;
use crate::subdivide::neighbourhoods::Neighbourhoods;

/// 9/16 itself, 7/(16 m) each of its m neighbours (4.24).
pub(crate) fn vertex(near: &Neighbourhoods, vertex: u32, row: &mut Row) {
    add_own_and_neighbours(near, vertex, 9.0 / 16.0, row);
}

/// Round an edge of four tets 1/4 the ends, 1/8 each link vertex (4.26); of
/// k ≠ 4 tets 5/16 and 3/(8 k) (4.25).
///
/// The first holds for every interior edge of four tets, regular or not: this
/// is what reproduces the published eigenvalues.
pub(crate) fn edge(near: &Neighbourhoods, edge: u32, row: &mut Row) {
    let tets = near.valence(edge);
    let (end, link) =
        if tets == 4 { (1.0 / 4.0, 1.0 / 8.0) } else { (5.0 / 16.0, 3.0 / (8.0 * tets as f64)) };
    for (vertex, is_end) in near.ends_and_link(edge) {
        row.add(vertex, if is_end { end } else { link });
    }
}
