//! From a scheme's masks to the subdivision matrix of a whole mesh.

use crate::raw_mesh::{Features, RawMesh};
use crate::reference_tet::opposite_ends;
use crate::scheme::{Mask, Scheme};
use crate::strata::Strata;
use crate::subdivision_matrix::{SubdivisionMatrix, linear_matrix};
use crate::tet_mesh::TetMesh;
use crate::topology::{EdgeTets, Topology, VertexEdges};

/// Everything a row is made from.
struct Neighbourhoods<'a> {
    mesh: &'a RawMesh,
    topology: &'a Topology,
    vertex_edges: &'a VertexEdges,
    edge_tets: EdgeTets,
    strata: Strata,
    scheme: Scheme,
}

/// The matrix of one step of a scheme on a mesh with its topology.
///
/// Its rows follow the mesh's features; a mesh without them counts as smooth.
pub fn subdivision_matrix(
    mesh: &TetMesh,
    topology: &Topology,
    scheme: Scheme,
) -> SubdivisionMatrix {
    matrix_with(mesh.raw(), topology, &VertexEdges::new(topology), scheme)
}

/// The same, with the edges at each vertex at hand.
pub(crate) fn matrix_with(
    mesh: &RawMesh,
    topology: &Topology,
    vertex_edges: &VertexEdges,
    scheme: Scheme,
) -> SubdivisionMatrix {
    if scheme == Scheme::Linear {
        return linear_matrix(topology);
    }
    let n = topology.vertex_count();
    let smooth = Features::default();
    let strata = Strata::new(mesh, topology, mesh.features.as_ref().unwrap_or(&smooth));
    let edge_tets = EdgeTets::new(topology);
    let near = Neighbourhoods { mesh, topology, vertex_edges, edge_tets, strata, scheme };
    SubdivisionMatrix::from_rows(
        n + topology.edges().len(),
        n,
        |row| match row.checked_sub(n) {
            None => near.vertex_row_length(row),
            Some(edge) => near.edge_row_length(edge),
        },
        |row, entries| match row.checked_sub(n) {
            None => near.vertex_row(row, entries),
            Some(edge) => near.edge_row(edge, entries),
        },
    )
}

impl Neighbourhoods<'_> {
    fn vertex_mask(&self, vertex: usize) -> (Mask, usize) {
        let dimension = self.strata.vertex_dimensions[vertex];
        let neighbours = match dimension {
            0 => 0,
            1 => self.strata.curve_neighbours(vertex as u32).len(),
            2 => self.strata.surface_neighbours(vertex as u32).len(),
            _ => self.vertex_edges.of(vertex).len(),
        };
        (self.scheme.vertex_mask(dimension, neighbours), neighbours)
    }

    fn vertex_row_length(&self, vertex: usize) -> usize {
        let (mask, neighbours) = self.vertex_mask(vertex);
        if mask.each == 0.0 { 1 } else { 1 + neighbours }
    }

    fn vertex_row(&self, vertex: usize, entries: &mut [(u32, f64)]) {
        let (mask, _) = self.vertex_mask(vertex);
        let (own, others) = entries.split_first_mut().expect("a row holds its own vertex");
        *own = (vertex as u32, mask.own);
        if others.is_empty() {
            return;
        }
        let mut fill = |neighbours: &mut dyn Iterator<Item = u32>| {
            for (entry, neighbour) in others.iter_mut().zip(neighbours) {
                *entry = (neighbour, mask.each);
            }
        };
        match self.strata.vertex_dimensions[vertex] {
            1 => fill(&mut self.strata.curve_neighbours(vertex as u32).iter().copied()),
            2 => fill(&mut self.strata.surface_neighbours(vertex as u32).iter().copied()),
            _ => fill(&mut self.vertex_edges.of(vertex).iter().map(|&edge| {
                let [a, b] = self.topology.edges()[edge as usize];
                a ^ b ^ vertex as u32
            })),
        }
    }

    /// The link of an interior edge is closed: as many vertices as tets.
    fn edge_mask(&self, edge: usize) -> (Mask, usize) {
        let dimension = self.strata.edge_dimensions[edge];
        let neighbours = match dimension {
            1 => 0,
            2 => self.strata.opposite_vertices(edge as u32).len(),
            _ => self.edge_tets.of(edge).len(),
        };
        (self.scheme.edge_mask(dimension, neighbours), neighbours)
    }

    fn edge_row_length(&self, edge: usize) -> usize {
        let (mask, neighbours) = self.edge_mask(edge);
        if mask.each == 0.0 { 2 } else { 2 + neighbours }
    }

    fn edge_row(&self, edge: usize, entries: &mut [(u32, f64)]) {
        let (mask, _) = self.edge_mask(edge);
        let (ends, others) = entries.split_at_mut(2);
        for (entry, end) in ends.iter_mut().zip(self.topology.edges()[edge]) {
            *entry = (end, mask.own);
        }
        if others.is_empty() {
            return;
        }
        if self.strata.edge_dimensions[edge] == 2 {
            for (entry, &vertex) in
                others.iter_mut().zip(self.strata.opposite_vertices(edge as u32))
            {
                *entry = (vertex, mask.each);
            }
        } else {
            self.link_row(edge, mask.each, others);
        }
    }

    /// Each link vertex belongs to two of the tets round the edge; write it once.
    fn link_row(&self, edge: usize, each: f64, entries: &mut [(u32, f64)]) {
        let mut filled = 0;
        for &slot in self.edge_tets.of(edge) {
            let tet = self.mesh.tets[slot as usize / 6];
            for vertex in opposite_ends(slot as usize % 6).map(|v| tet[v]) {
                if entries[..filled].iter().all(|entry| entry.0 != vertex) {
                    entries[filled] = (vertex, each);
                    filled += 1;
                }
            }
        }
        debug_assert_eq!(filled, entries.len(), "the link of an interior edge is closed");
    }
}
