//! The interpolatory scheme inside a solid (Chang's thesis, chapter 5).

use super::shares::add_ends;
use crate::refinement::subdivision_matrix::Row;
use crate::scheme::MarkedRule;
use crate::subdivide::neighbourhoods::Neighbourhoods;

/// ½ the ends, (M/N) w each of the N link vertices q, −w each of the M distinct
/// apexes r across the outer faces of the tets round the edge (5.7).
///
/// Where an outer face lies on a surface, the apex is the ghost that the
/// regular lattice would have there, so that linear functions are reproduced.
pub(crate) fn edge(near: &Neighbourhoods, edge: u32, w: f64, marked: MarkedRule, row: &mut Row) {
    if marked == MarkedRule::PlaneButterfly && near.is_marked_by_four(edge) {
        return plane_butterfly(near, edge, w, row);
    }
    add_ends(near, edge, 0.5, row);
    let apexes = near.apexes(edge);
    let link = apexes.len() as f64 / near.valence(edge) as f64 * w;
    near.link(edge).for_each(|vertex| row.add(vertex, link));
    for apex in apexes {
        apex.into_iter().for_each(|(vertex, weight)| row.add(vertex, -w * weight));
    }
}

/// The rule of an edge that all its four tets mark: the mean of the butterfly
/// rules in the two lattice planes through it.
///
/// The published rule for these edges (5.9) has eigenvalues above 1/2 at a
/// regular vertex for every w > 0; this one is what symmetrising the printed
/// coefficients gives, and reproduces cubics at w = 1/16.
fn plane_butterfly(near: &Neighbourhoods, edge: u32, w: f64, row: &mut Row) {
    let [a, b] = near.ends(edge);
    add_ends(near, edge, 0.5, row);
    near.link(edge).for_each(|vertex| row.add(vertex, w));
    for c in near.link(edge) {
        for (end, other) in [(a, b), (b, a)] {
            near.solid_wing([end, c], other)
                .into_iter()
                .for_each(|(vertex, weight)| row.add(vertex, -0.5 * w * weight));
        }
    }
}
