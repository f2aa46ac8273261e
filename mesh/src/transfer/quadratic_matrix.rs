//! Quadratic interpolation on the tets of the level below: the transfer of full
//! multigrid that is exact for quadratics on any flat mesh.
//!
//! A red-refined mesh has, in each tet of the mesh that it came from, the ten nodes
//! of a quadratic element: four vertices and six midpoints. The next refinement
//! puts its new vertices on midpoints of edges, which lie at three kinds of places
//! in that tet.

use crate::core::topology::Topology;
use crate::refinement::subdivision_matrix::{Row, SubdivisionMatrix};

/// From a mesh to its red refinement by quadratic interpolation on the tets of the
/// mesh `parent` that `middle` refines: of three consecutive meshes of a hierarchy,
/// the topologies of the first two, and a matrix between the last two.
///
/// # Panics
/// If `middle` has not the number of vertices of a refinement of `parent`.
pub fn quadratic_matrix(parent: &Topology, middle: &Topology) -> SubdivisionMatrix {
    let vertices = middle.vertex_count();
    let expected = parent.vertex_count() + parent.edges().len();
    assert_eq!(vertices, expected, "vertices of a refined mesh");
    let edges = middle.edges();
    SubdivisionMatrix::from_rows(vertices + edges.len(), vertices, |row, entries| {
        match row.checked_sub(vertices) {
            None => entries.add(row as u32, 1.0),
            Some(edge) => add_midpoint(parent, edges[edge], entries),
        }
    })
}

/// The value at the midpoint of an edge of the middle mesh. With barycentric
/// coordinates λ, vertex i of a quadratic element weighs λᵢ (2 λᵢ − 1), the
/// midpoint of edge ij 4 λᵢ λⱼ.
fn add_midpoint(parent: &Topology, [p, q]: [u32; 2], row: &mut Row) {
    let old = parent.vertex_count() as u32;
    let edges = parent.edges();
    let mut add = |entries: &[(u32, f64)]| {
        entries.iter().for_each(|&(vertex, weight)| row.add(vertex, weight));
    };
    // Should the middle mesh be no red refinement, its own edges interpolate.
    let linear = [(p, 0.5), (q, 0.5)];
    let Some(second) = q.checked_sub(old) else { return add(&linear) };
    let [c, d] = edges[second as usize];
    let middle_of = |[a, b]: [u32; 2]| parent.edge_between(a, b).map(|edge| old + edge);
    let Some(first) = p.checked_sub(old) else {
        // A quarter of the way along an edge of the parent.
        let far = if c == p { d } else { c };
        return add(&[(p, 0.375), (far, -0.125), (q, 0.75)]);
    };
    let [a, b] = edges[first as usize];
    let shared = [a, b].into_iter().find(|v| [c, d].contains(v));
    match shared {
        // λ = (½, ¼, ¼) on a face.
        Some(apex) => {
            let (b, c) = (if a == apex { b } else { a }, if c == apex { d } else { c });
            let Some(opposite) = middle_of([b, c]) else { return add(&linear) };
            add(&[(b, -0.125), (c, -0.125), (p, 0.5), (q, 0.5), (opposite, 0.25)]);
        }
        // The centroid: the edge is an inner diagonal.
        None => {
            let across = [[a, c], [a, d], [b, c], [b, d]].map(middle_of);
            let [Some(ac), Some(ad), Some(bc), Some(bd)] = across else { return add(&linear) };
            add(&[a, b, c, d].map(|vertex| (vertex, -0.125)));
            add(&[p, q, ac, ad, bc, bd].map(|midpoint| (midpoint, 0.25)));
        }
    }
}
