//! Rules on surface strata: the boundary, interfaces, and surfaces asked for.

use std::f64::consts::TAU;

use super::shares::add_ends;
use crate::refinement::subdivision_matrix::Row;
use crate::subdivide::neighbourhoods::Neighbourhoods;

/// Loop's vertex rule with Warren's weights: each of n neighbours 3/(8 n), or
/// 3/16 for n = 3.
pub(crate) fn loop_vertex(near: &Neighbourhoods, vertex: u32, row: &mut Row) {
    let neighbours = near.strata.surface_neighbours(vertex);
    let n = neighbours.len();
    let each = warren_weight(n);
    row.add(vertex, 1.0 - n as f64 * each);
    if each != 0.0 {
        neighbours.iter().for_each(|&neighbour| row.add(neighbour, each));
    }
}

/// The weight of each of n neighbours in the vertex rule.
pub(super) fn warren_weight(n: usize) -> f64 {
    // A surface needs three neighbours round a vertex.
    if n < 3 { 0.0 } else { neighbours_share(n) / n as f64 }
}

/// What n neighbours, at least three, weigh together in the vertex rule.
pub(crate) fn neighbours_share(n: usize) -> f64 {
    if n == 3 { 9.0 / 16.0 } else { 3.0 / 8.0 }
}

/// What a smooth vertex weighs in its limit against 1 for each of n neighbours, at least
/// three.
pub(crate) fn limit_own_weight(n: usize) -> f64 {
    if n == 3 { 2.0 } else { n as f64 }
}

/// Loop's edge rule: 3/8 the ends, 1/8 the opposite vertices.
pub(crate) fn loop_edge(near: &Neighbourhoods, edge: u32, row: &mut Row) {
    add_ends(near, edge, 3.0 / 8.0, row);
    near.strata.opposite_vertices(edge).iter().for_each(|&vertex| row.add(vertex, 1.0 / 8.0));
}

/// The modified butterfly rule (Zorin, Schröder and Sweldens 1996): between
/// regular ends the butterfly; at one extraordinary end its own stencil, at two
/// the mean of both.
///
/// An end on a curve or corner has no full ring and counts as regular; wings
/// that would lie across a curve are reflected.
pub(crate) fn butterfly_edge(near: &Neighbourhoods, edge: u32, w: f64, row: &mut Row) {
    let [a, b] = near.ends(edge);
    let rings =
        [(a, b), (b, a)].map(|(centre, first)| (centre, near.extraordinary_ring(centre, first)));
    let extraordinary = rings.iter().filter(|(_, ring)| ring.is_some()).count() as f64;
    if extraordinary == 0.0 {
        return regular_butterfly(near, [a, b], edge, w, row);
    }
    for (centre, ring) in rings {
        let Some(ring) = ring else { continue };
        let mut own = 1.0;
        for (j, &vertex) in ring.iter().enumerate() {
            let weight = zorin_weight(j, ring.len());
            own -= weight;
            row.add(vertex, weight / extraordinary);
        }
        row.add(centre, own / extraordinary);
    }
}

fn regular_butterfly(near: &Neighbourhoods, [a, b]: [u32; 2], edge: u32, w: f64, row: &mut Row) {
    add_ends(near, edge, 0.5, row);
    for &c in near.strata.opposite_vertices(edge) {
        row.add(c, 2.0 * w);
        for (end, other) in [(a, b), (b, a)] {
            near.surface_wing([end, c], other)
                .for_each(|(vertex, weight)| row.add(vertex, -w * weight));
        }
    }
}

/// The weight of the j-th neighbour round an extraordinary vertex of valence k,
/// counted from the other end of the edge.
fn zorin_weight(j: usize, k: usize) -> f64 {
    match (k, j) {
        (3, 0) => 5.0 / 12.0,
        (3, _) => -1.0 / 12.0,
        (4, 0) => 3.0 / 8.0,
        (4, 2) => -1.0 / 8.0,
        (4, _) => 0.0,
        _ => {
            let turn = TAU * j as f64 / k as f64;
            (0.25 + turn.cos() + 0.5 * (2.0 * turn).cos()) / k as f64
        }
    }
}
