//! A matrix of couplings along the edges of a mesh, row by row.

use crate::boundary::dofs::Dofs;
use octruss_base::groups::Groups;
use octruss_mesh::Topology;
use octruss_solver::Csr;
use octruss_solver::Entry;
use octruss_solver::build_rows;

/// The edges at each vertex with their other ends.
pub(crate) struct Neighbours<'a> {
    topology: &'a Topology,
    /// The edges whose higher end is each vertex.
    ending: Groups<u32>,
}

impl<'a> Neighbours<'a> {
    pub(crate) fn new(topology: &'a Topology) -> Self {
        Self { topology, ending: topology.edges_to() }
    }

    /// How many edges a vertex has.
    fn count(&self, vertex: u32) -> usize {
        let vertex = vertex as usize;
        self.ending.of(vertex).len() + self.topology.edges_from(vertex).len()
    }

    /// (edge, other end) at a vertex; edges and other ends ascend.
    #[inline]
    pub(crate) fn of(&self, vertex: u32) -> impl Iterator<Item = (u32, u32)> {
        let (vertex, edges) = (vertex as usize, self.topology.edges());
        let ending = self.ending.of(vertex).iter().map(move |&e| (e, edges[e as usize][0]));
        let from = self.topology.edges_from(vertex).map(move |e| (e, edges[e as usize][1]));
        ending.chain(from)
    }

    /// Whether a vertex is the lower end of an edge.
    #[inline]
    pub(crate) fn is_lower(&self, edge: u32, vertex: u32) -> bool {
        self.topology.edges()[edge as usize][0] == vertex
    }

    /// How many neighbours of each vertex have no unknown.
    fn fixed(&self, dofs: &Dofs) -> Vec<u32> {
        let mut fixed = vec![0; dofs.vertices()];
        for vertex in (0..dofs.vertices() as u32).filter(|v| dofs.unknown(*v).is_none()) {
            self.of(vertex).for_each(|(_, other)| fixed[other as usize] += 1);
        }
        fixed
    }
}

/// The row of each unknown: with `coupling(edge, vertex)` for each neighbour
/// along an edge, `stored(vertex, other, coupling)` where that has an unknown, and
/// on the diagonal `diagonal(vertex, sum of all couplings)`.
pub(crate) fn edge_rows<E: Entry<Real = f64>>(
    dofs: &Dofs,
    neighbours: &Neighbours,
    coupling: impl Fn(u32, u32) -> E + Sync,
    stored: impl Fn(u32, u32, E) -> E + Sync,
    diagonal: impl Fn(u32, E) -> E + Sync,
) -> Csr<E> {
    let fixed = neighbours.fixed(dofs);
    build_rows(
        (dofs.unknowns(), dofs.unknowns()),
        |row| {
            let vertex = dofs.free()[row];
            1 + neighbours.count(vertex) - fixed[vertex as usize] as usize
        },
        |row, indices, values| {
            let vertex = dofs.free()[row];
            let (mut at, mut own, mut sum) = (0, None, E::default());
            // A `for` loop would ask each time which of the chained lists it is in.
            neighbours.of(vertex).for_each(|(edge, other)| {
                let value = coupling(edge, vertex);
                sum = sum.add_scaled(1.0, value);
                let Some(column) = dofs.unknown(other) else { return };
                // Other ends ascend; the row itself goes before the first larger one.
                if own.is_none() && column as usize > row {
                    own = Some(at);
                    at += 1;
                }
                (indices[at], values[at]) = (column, stored(vertex, other, value));
                at += 1;
            });
            let own = own.unwrap_or(at);
            (indices[own], values[own]) = (row as u32, diagonal(vertex, sum));
        },
    )
}
