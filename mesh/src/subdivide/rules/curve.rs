//! Rules along curve strata: creases, borders, and curves of their own.

use super::shares::midpoint;
use crate::refinement::subdivision_matrix::Row;
use crate::subdivide::neighbourhoods::Neighbourhoods;

/// Cubic B-spline: 1/8, 3/4, 1/8.
pub(crate) fn smooth_vertex(near: &Neighbourhoods, vertex: u32, row: &mut Row) {
    row.add(vertex, 3.0 / 4.0);
    near.strata
        .curve_neighbours(vertex)
        .iter()
        .for_each(|&neighbour| row.add(neighbour, 1.0 / 8.0));
}

/// Four-point rule: 1/2 + w the ends, −w the next vertices along the curve.
///
/// Beyond a corner or the end of the curve, the missing vertex is extrapolated
/// from the quadratic through the other three; a curve of one edge is halved.
pub(crate) fn four_point_edge(near: &Neighbourhoods, edge: u32, w: f64, row: &mut Row) {
    let [a, b] = near.ends(edge);
    match [near.beyond(b, a), near.beyond(a, b)] {
        [Some(before), Some(after)] => {
            [a, b].into_iter().for_each(|end| row.add(end, 0.5 + w));
            [before, after].into_iter().for_each(|next| row.add(next, -w));
        }
        [None, Some(after)] => extrapolated(a, b, after, w, row),
        [Some(before), None] => extrapolated(b, a, before, w, row),
        [None, None] => midpoint(near, edge, row),
    }
}

/// The rule between `end`, where the curve stops, and `inner`, with `next` after it.
fn extrapolated(end: u32, inner: u32, next: u32, w: f64, row: &mut Row) {
    row.add(end, 0.5 - 2.0 * w);
    row.add(inner, 0.5 + 4.0 * w);
    row.add(next, -2.0 * w);
}
