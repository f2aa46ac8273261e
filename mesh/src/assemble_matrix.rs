//! From a scheme's masks to the subdivision matrix of a whole mesh.

use crate::raw_mesh::{Features, RawMesh};
use crate::reference_tet::opposite_ends;
use crate::scheme::Scheme;
use crate::strata::Strata;
use crate::subdivision_matrix::{Row, SubdivisionMatrix, linear_matrix};
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
    SubdivisionMatrix::from_rows(n + topology.edges().len(), n, |row, entries| {
        match row.checked_sub(n) {
            None => near.vertex_row(row, entries),
            Some(edge) => near.edge_row(edge, entries),
        }
    })
}

impl Neighbourhoods<'_> {
    fn vertex_row(&self, vertex: usize, row: &mut Row) {
        let v = vertex as u32;
        match self.strata.vertex_dimensions[vertex] {
            0 => row.add(v, 1.0),
            1 => self.masked_vertex(v, 1, self.strata.curve_neighbours(v).iter().copied(), row),
            2 => self.masked_vertex(v, 2, self.strata.surface_neighbours(v).iter().copied(), row),
            _ => {
                let other_end = |&edge: &u32| {
                    let [a, b] = self.topology.edges()[edge as usize];
                    a ^ b ^ v
                };
                self.masked_vertex(v, 3, self.vertex_edges.of(vertex).iter().map(other_end), row);
            }
        }
    }

    fn masked_vertex(
        &self,
        vertex: u32,
        dimension: u8,
        neighbours: impl ExactSizeIterator<Item = u32>,
        row: &mut Row,
    ) {
        let mask = self.scheme.vertex_mask(dimension, neighbours.len());
        row.add(vertex, mask.own);
        if mask.each != 0.0 {
            neighbours.for_each(|neighbour| row.add(neighbour, mask.each));
        }
    }

    fn edge_row(&self, edge: usize, row: &mut Row) {
        let dimension = self.strata.edge_dimensions[edge];
        let opposite = self.strata.opposite_vertices(edge as u32);
        let round = self.edge_tets.of(edge);
        // The link of an interior edge is closed: as many vertices as tets.
        let neighbours = if dimension == 2 { opposite.len() } else { round.len() };
        let mask = self.scheme.edge_mask(dimension, neighbours);
        self.topology.edges()[edge].into_iter().for_each(|end| row.add(end, mask.own));
        match dimension {
            2 => opposite.iter().for_each(|&vertex| row.add(vertex, mask.each)),
            3 => self.link(round).for_each(|vertex| row.add(vertex, 0.5 * mask.each)),
            _ => {}
        }
    }

    /// The link vertices of the tets round an edge: each belongs to two of them
    /// and comes twice.
    fn link(&self, round: &[u32]) -> impl Iterator<Item = u32> {
        round.iter().flat_map(|&slot| {
            let tet = self.mesh.tets[slot as usize / 6];
            opposite_ends(slot as usize % 6).map(|v| tet[v])
        })
    }
}
