//! The parts of tagged triangles, tagged edges and creases.

use crate::adapt::bisection::bisected;
use crate::adapt::midpoints::Midpoints;
use crate::adapt::parts::{Parts, all_parts, counts};
use crate::adapt::quarters::quartered;
use crate::core::raw_mesh::Tagged;
use crate::core::topology::{Topology, ascending};
use crate::refinement::lineage::Lineage;

/// The parts of a triangle: whole, bisected as the faces of tets are, or quartered.
pub(super) fn of_triangle(
    topology: &Topology,
    midpoints: &Midpoints,
    triangle: [u32; 3],
) -> Parts<3> {
    let face = topology.face_of(triangle).expect("tagged triangles have their faces numbered");
    let edges = topology.face_edges()[face as usize];
    match edges.iter().all(|&edge| midpoints.is_split(edge)) {
        true => quartered(triangle, [0, 1, 2], |a, b| midpoints.between(a, b)),
        false => bisected(triangle, &midpoints.cuts(edges)),
    }
}

/// The parts of an edge: itself or its halves.
pub(super) fn of_edge(topology: &Topology, midpoints: &Midpoints, ends: [u32; 2]) -> Parts<2> {
    let [a, b] = ends;
    let edge = topology.edge_between(a, b).expect("tagged edges are numbered");
    if midpoints.is_split(edge) {
        let middle = midpoints.of_edge(edge);
        return Parts::from_iter([[a, middle], [middle, b]]);
    }
    Parts::from_iter([ends])
}

/// The parts of tagged simplices, with the tags of their wholes.
pub(super) fn split_each<const N: usize>(
    coarse: &Tagged<N>,
    parts: impl Fn([u32; N]) -> Parts<N> + Sync,
) -> (Tagged<N>, Lineage)
where
    [u32; N]: Default,
{
    let parts = |at: usize| parts(coarse.simplices[at]);
    let (simplices, parents) = all_parts(&counts(coarse.len(), |at| parts(at).len()), parts);
    let lineage = Lineage::listed(parents);
    let tags = lineage.inherit(&coarse.tags, 1);
    (Tagged { simplices, tags }, lineage)
}

/// The creases of the fine mesh, in the order of [`crate::Features::creases`].
pub(super) fn split_creases(
    creases: &[[u32; 2]],
    topology: &Topology,
    midpoints: &Midpoints,
) -> Vec<[u32; 2]> {
    let parts = creases.iter().flat_map(|&ends| of_edge(topology, midpoints, ends));
    let mut creases: Vec<_> = parts.map(ascending).collect();
    creases.sort_unstable();
    creases
}
