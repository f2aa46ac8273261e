//! Quadratic interpolation on the tets of the level below: the transfer of full
//! multigrid that is exact for quadratics on any flat mesh.
//!
//! A red-refined mesh has, in each tet of the mesh that it came from, the ten nodes
//! of a quadratic element: four vertices and six midpoints. The next refinement
//! puts its new vertices on midpoints of edges, which lie at three kinds of places
//! in that tet.

use crate::csr::Csr;
use crate::dofs::Dofs;
use crate::error::{Error, check_size};
use crate::rows::build_rows;
use octruss_mesh::Topology;

/// (vertex of the middle mesh, weight).
type Row = Vec<(u32, f64)>;

/// The matrix from the free unknowns of a mesh to those of its red refinement, by
/// quadratic interpolation on the tets of the mesh `parent` that `middle` refines.
///
/// Of three consecutive meshes of a hierarchy, `parent` and `middle` are the
/// topologies of the first two, `coarse` and `fine` the unknowns of the last two.
/// Prescribed values count as zero.
///
/// # Errors
/// [`Error::Size`] if the four do not belong together.
pub fn quadratic_transfer(
    parent: &Topology,
    middle: &Topology,
    fine: &Dofs,
    coarse: &Dofs,
) -> Result<Csr<f64>, Error> {
    let vertices = parent.vertex_count() + parent.edges().len();
    check_size("vertices of a refined mesh", middle.vertex_count(), vertices)?;
    check_size("vertices of the coarse unknowns", coarse.vertices(), vertices)?;
    check_size("vertices of the fine unknowns", fine.vertices(), vertices + middle.edges().len())?;
    let row = |unknown: usize| -> Row {
        let vertex = fine.free()[unknown] as usize;
        let all = match vertex.checked_sub(vertices) {
            None => vec![(vertex as u32, 1.0)],
            Some(edge) => midpoint(parent, middle.edges()[edge]),
        };
        let free = |(vertex, weight)| coarse.unknown(vertex).map(|column| (column, weight));
        let mut row: Row = all.into_iter().filter_map(free).collect();
        row.sort_unstable_by_key(|(column, _)| *column);
        row
    };
    Ok(build_rows(
        (fine.unknowns(), coarse.unknowns()),
        |unknown| row(unknown).len(),
        |unknown, indices, values| {
            for ((index, value), entry) in indices.iter_mut().zip(values).zip(row(unknown)) {
                (*index, *value) = entry;
            }
        },
    ))
}

/// The value at the midpoint of an edge of the middle mesh. With barycentric
/// coordinates λ, vertex i of a quadratic element weighs λᵢ (2 λᵢ − 1), the
/// midpoint of edge ij 4 λᵢ λⱼ.
fn midpoint(parent: &Topology, [p, q]: [u32; 2]) -> Row {
    let old = parent.vertex_count() as u32;
    let edges = parent.edges();
    // Should the middle mesh be no red refinement, its own edges interpolate.
    let linear = || vec![(p, 0.5), (q, 0.5)];
    let Some(second) = q.checked_sub(old) else { return linear() };
    let [c, d] = edges[second as usize];
    let middle_of = |a: u32, b: u32| parent.edge_between(a, b).map(|edge| old + edge);
    let Some(first) = p.checked_sub(old) else {
        // A quarter of the way along an edge of the parent.
        let far = if c == p { d } else { c };
        return vec![(p, 0.375), (far, -0.125), (q, 0.75)];
    };
    let [a, b] = edges[first as usize];
    let shared = [a, b].into_iter().find(|v| [c, d].contains(v));
    match shared {
        // λ = (½, ¼, ¼) on a face.
        Some(apex) => {
            let (b, c) = (if a == apex { b } else { a }, if c == apex { d } else { c });
            let Some(opposite) = middle_of(b, c) else { return linear() };
            vec![(b, -0.125), (c, -0.125), (p, 0.5), (q, 0.5), (opposite, 0.25)]
        }
        // The centroid: the edge is an inner diagonal.
        None => {
            let across = [(a, c), (a, d), (b, c), (b, d)].map(|(u, v)| middle_of(u, v));
            let mut row: Row = [a, b, c, d].map(|v| (v, -0.125)).into();
            row.extend([(p, 0.25), (q, 0.25)]);
            row.extend(across.into_iter().flatten().map(|m| (m, 0.25)));
            if row.len() == 10 { row } else { linear() }
        }
    }
}
