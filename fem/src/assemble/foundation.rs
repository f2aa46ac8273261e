//! What resists on a surface in proportion to the unknown: Robin conditions and
//! springs, ∫ c φ_a φ_b over triangles.

use crate::assemble::scatter::Sums;
use crate::element::p1::triangle_area;
use octruss_mesh::Topology;

/// The couplings of edges and, since rows no longer sum to zero, the row sums at
/// vertices; `K` numbers each: 1 for a scalar, 9 for a symmetric 3 × 3 block.
pub(crate) struct Foundation<'a, const K: usize> {
    topology: &'a Topology,
    couplings: &'a mut Sums<K>,
    /// ∫ c φ_a for each vertex; empty as long as nothing was added.
    row_sums: Vec<[f64; K]>,
}

impl<'a, const K: usize> Foundation<'a, K> {
    /// Adds to the couplings of a topology's edges.
    pub(crate) fn new(topology: &'a Topology, couplings: &'a mut Sums<K>) -> Self {
        Self { topology, couplings, row_sums: Vec::new() }
    }

    /// Adds a triangle by the rule at the midpoints of its edges, exact for
    /// constant c: at the midpoint of ab, φ_a = φ_b = 1/2 and the third is 0.
    pub(crate) fn add(
        &mut self,
        vertices: [u32; 3],
        corners: [[f64; 3]; 3],
        c: impl Fn([f64; 3]) -> [f64; K],
    ) {
        self.row_sums.resize(self.topology.vertex_count(), [0.0; K]);
        let share = triangle_area(corners) / 12.0;
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let middle = std::array::from_fn(|k| 0.5 * (corners[a][k] + corners[b][k]));
            let value = c(middle).map(|c| share * c);
            if let Some(edge) = self.topology.edge_between(vertices[a], vertices[b]) {
                self.couplings.add_to(edge, value);
            }
            for vertex in [a, b] {
                add_times(2.0, value, &mut self.row_sums[vertices[vertex] as usize]);
            }
        }
    }

    /// The row sums of all vertices; empty if nothing was added.
    pub(crate) fn into_row_sums(self) -> Vec<[f64; K]> {
        self.row_sums
    }
}

fn add_times<const K: usize>(factor: f64, values: [f64; K], to: &mut [f64; K]) {
    (0..K).for_each(|k| to[k] += factor * values[k]);
}
