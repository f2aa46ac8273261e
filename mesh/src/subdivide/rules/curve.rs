//! Rules along curve strata: creases, borders, and curves of their own.

use super::shares::midpoint;
use crate::core::curve_ends::CurveEnds;
use crate::core::strata::Strata;
use crate::refinement::subdivision_matrix::Row;
use crate::subdivide::neighbourhoods::Neighbourhoods;

/// Cubic B-spline: 1/8, 3/4, 1/8. Beside a parabola's end 3/28, 22/28, 3/28, between
/// two of them 3/32, 26/32, 3/32.
pub(crate) fn smooth_vertex(strata: &Strata, vertex: u32, ends: CurveEnds, row: &mut Row) {
    let each = match parabola_ends(strata, vertex, ends) {
        0 => 1.0 / 8.0,
        1 => 3.0 / 28.0,
        _ => 3.0 / 32.0,
    };
    row.add(vertex, 1.0 - 2.0 * each);
    strata.curve_neighbours(vertex).iter().for_each(|&neighbour| row.add(neighbour, each));
}

/// How many of a curve vertex's two neighbours are ends at which parabolas are
/// reproduced.
pub(super) fn parabola_ends(strata: &Strata, vertex: u32, ends: CurveEnds) -> usize {
    match ends {
        CurveEnds::Fixed => 0,
        CurveEnds::Parabola => {
            let neighbours = strata.curve_neighbours(vertex).iter();
            neighbours.filter(|&&v| strata.vertex_dimensions[v as usize] == 0).count()
        }
    }
}

/// Cubic B-spline: the midpoint. From a parabola's end on 6/14, 9/14, −1/14, on a curve
/// of two edges 7/16, 10/16, −1/16; these leave a parabola with its end at parameter 0
/// and the next vertices at 1 and 2 what it is.
pub(crate) fn smooth_edge(near: &Neighbourhoods, edge: u32, ends: CurveEnds, row: &mut Row) {
    let [a, b] = near.ends(edge);
    let is_end = |v: u32| near.strata.vertex_dimensions[v as usize] == 0;
    for (end, inner) in [(a, b), (b, a)] {
        let beyond = near.strata.beyond(end, inner).filter(|_| is_end(end));
        if let (CurveEnds::Parabola, Some(next)) = (ends, beyond) {
            let total = if is_end(next) { 16.0 } else { 14.0 };
            row.add(end, (0.5 * total - 1.0) / total);
            row.add(inner, (0.5 * total + 2.0) / total);
            row.add(next, -1.0 / total);
            return;
        }
    }
    midpoint(near, edge, row);
}

/// Four-point rule: 1/2 + w the ends, −w the next vertices along the curve.
///
/// Beyond a corner or the end of the curve, the missing vertex is extrapolated
/// from the quadratic through the other three; a curve of one edge is halved.
pub(crate) fn four_point_edge(near: &Neighbourhoods, edge: u32, w: f64, row: &mut Row) {
    let [a, b] = near.ends(edge);
    match [near.strata.beyond(b, a), near.strata.beyond(a, b)] {
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
