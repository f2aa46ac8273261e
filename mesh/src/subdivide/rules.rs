//! The rule table: for each dimension of stratum one vertex rule and one edge
//! rule, by scheme.
//!
//! | stratum | approximating schemes | interpolatory |
//! | --- | --- | --- |
//! | point | fixed | fixed |
//! | curve | cubic B-spline | four-point |
//! | surface | Loop with Warren's weights | modified butterfly |
//! | solid | the scheme's own | the scheme's own |

mod averaged;
mod box_spline;
mod curve;
mod interpolatory;
mod loop_solid;
mod surface;

use crate::refinement::subdivision_matrix::Row;
use crate::scheme::Scheme;
use crate::subdivide::neighbourhoods::Neighbourhoods;

/// Adds the entries of the row of a coarse vertex.
pub(crate) fn vertex_row(scheme: Scheme, near: &Neighbourhoods, vertex: u32, row: &mut Row) {
    let dimension = near.strata.vertex_dimensions[vertex as usize];
    match (dimension, scheme) {
        (0, _) => row.add(vertex, 1.0),
        _ if scheme.keeps_vertices() => row.add(vertex, 1.0),
        (1, _) => curve::smooth_vertex(near, vertex, row),
        (2, _) => surface::loop_vertex(near, vertex, row),
        (_, Scheme::Averaged) => averaged::vertex(near, vertex, row),
        (_, Scheme::LoopSolid { interior, .. }) => loop_solid::vertex(near, vertex, interior, row),
        _ => box_spline::vertex(near, vertex, row),
    }
}

/// Adds the entries of the row of an edge, for its new vertex.
pub(crate) fn edge_row(scheme: Scheme, near: &Neighbourhoods, edge: u32, row: &mut Row) {
    let dimension = near.strata.edge_dimensions[edge as usize];
    match (dimension, scheme) {
        (_, Scheme::Linear) => midpoint(near, edge, row),
        (1, Scheme::Interpolatory { tension, .. }) => {
            curve::four_point_edge(near, edge, tension, row)
        }
        (1, _) => midpoint(near, edge, row),
        (2, Scheme::Interpolatory { tension, .. }) => {
            surface::butterfly_edge(near, edge, tension, row)
        }
        (2, _) => surface::loop_edge(near, edge, row),
        (_, Scheme::Averaged) => averaged::edge(near, edge, row),
        (_, Scheme::Interpolatory { tension, marked }) => {
            interpolatory::edge(near, edge, tension, marked, row)
        }
        (_, Scheme::LoopSolid { .. }) => midpoint(near, edge, row),
        (_, Scheme::BoxSpline) => box_spline::edge(near, edge, row),
    }
}

/// The weight `own` for a vertex of the solid, the rest shared by its neighbours.
fn add_own_and_neighbours(near: &Neighbourhoods, vertex: u32, own: f64, row: &mut Row) {
    let neighbours = near.neighbours(vertex);
    let each = (1.0 - own) / neighbours.clone().count() as f64;
    let lower = neighbours.clone().take_while(|&other| other < vertex);
    lower.for_each(|neighbour| row.add(neighbour, each));
    row.add(vertex, own);
    let higher = neighbours.skip_while(|&other| other < vertex);
    higher.for_each(|neighbour| row.add(neighbour, each));
}

fn midpoint(near: &Neighbourhoods, edge: u32, row: &mut Row) {
    add_ends(near, edge, 0.5, row);
}

fn add_ends(near: &Neighbourhoods, edge: u32, weight: f64, row: &mut Row) {
    near.ends(edge).into_iter().for_each(|end| row.add(end, weight));
}
