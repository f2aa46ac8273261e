//! Where the vertices inside a solid tend to.

use nalgebra::{DMatrix, DVector};

use crate::core::incidence::Incidence;
use crate::core::strata::Strata;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::{Topology, VertexEdges};
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::scheme::Scheme;
use crate::subdivide::assemble_matrix::subdivision_matrix;

/// How far a row may be from an eigenvector to count as one.
const RESIDUAL: f64 = 1e-15;

/// The limits of the vertices inside the solid, n × n: row v holds the left
/// eigenvector to the eigenvalue 1 of the local matrix at v, its sum one.
///
/// Vertices of surfaces, curves and points have rows of the identity, and so
/// have all under a scheme that keeps vertices. The rows hold for refinement by
/// the same scheme without a guard.
pub fn solid_limit_matrix(
    mesh: &TetMesh,
    topology: &Topology,
    scheme: Scheme,
) -> SubdivisionMatrix {
    let n = topology.vertex_count();
    let features = mesh.features().cloned().unwrap_or_default();
    let strata = Strata::new(mesh.raw(), topology, &features);
    let stars = Stars {
        step: subdivision_matrix(mesh, topology, scheme),
        vertex_edges: VertexEdges::new(topology),
        diagonals: diagonals(mesh, topology),
        topology,
    };
    SubdivisionMatrix::from_rows(n, n, |row, entries| {
        let vertex = row as u32;
        let is_inside =
            strata.vertex_dimensions[row] == 3 && !stars.vertex_edges.of(row).is_empty();
        if scheme.keeps_vertices() || !is_inside {
            return entries.add(vertex, 1.0);
        }
        let star = stars.at(vertex);
        let weights = limit(&star.matrix, &star.guess);
        star.vertices
            .iter()
            .zip(&weights)
            .for_each(|(&column, &weight)| entries.add(column, weight));
    })
}

/// What the local matrices of a mesh are taken from.
struct Stars<'a> {
    step: SubdivisionMatrix,
    vertex_edges: VertexEdges,
    /// For each vertex the diagonals of octahedra that it is on the equator of.
    diagonals: Incidence,
    topology: &'a Topology,
}

/// The local matrix at a vertex, in places that halve towards it.
struct Star {
    /// The vertices of the cells at the vertex, itself first.
    vertices: Vec<u32>,
    matrix: DMatrix<f64>,
    /// The eigenvector, if all is regular.
    guess: DVector<f64>,
}

impl Stars<'_> {
    fn at(&self, vertex: u32) -> Star {
        let n = self.topology.vertex_count();
        // The place of a neighbour is a level later that of the edge's new vertex.
        let (mut vertices, mut rows) = (vec![vertex], vec![vertex as usize]);
        for &edge in self.vertex_edges.of(vertex as usize) {
            let [a, b] = self.topology.edges()[edge as usize];
            vertices.push(a ^ b ^ vertex);
            rows.push(n + edge as usize);
        }
        let neighbours = vertices.len();
        // That of the vertex opposite across an octahedron is its centre.
        for &column in self.step.row(vertex as usize).0 {
            let centre = |&&d: &&u32| self.step.row(n + d as usize).0.contains(&column);
            if !vertices[..neighbours].contains(&column)
                && let Some(&diagonal) = self.diagonals.of(vertex).iter().find(centre)
            {
                vertices.push(column);
                rows.push(n + diagonal as usize);
            }
        }
        let mut matrix = DMatrix::zeros(vertices.len(), vertices.len());
        for (i, &row) in rows.iter().enumerate() {
            let (columns, weights) = self.step.row(row);
            for (column, &weight) in columns.iter().zip(weights) {
                let place = vertices.iter().position(|v| v == column);
                matrix[(i, place.expect("rules read the cells at their edge"))] += weight;
            }
        }
        let guess =
            DVector::from_iterator(vertices.len(), rows.iter().map(|&row| self.guess(row, n)));
        Star { vertices, matrix, guess }
    }

    /// The weights of the regular interior under the box-spline scheme: edges of
    /// four tets and of six.
    fn guess(&self, row: usize, n: usize) -> f64 {
        match self.step.row(row).0.len() {
            _ if row < n => 2.0 / 5.0,
            6 => 1.0 / 30.0,
            _ => 1.0 / 20.0,
        }
    }
}

/// The left eigenvector of the eigenvalue 1, its sum one.
fn limit(matrix: &DMatrix<f64>, guess: &DVector<f64>) -> Vec<f64> {
    if (matrix.tr_mul(guess) - guess).amax() < RESIDUAL {
        return guess.iter().copied().collect();
    }
    // One of the equations follows from the others; the sum takes its place.
    let size = matrix.nrows();
    let mut system = matrix.transpose() - DMatrix::identity(size, size);
    system.row_mut(0).fill(1.0);
    let mut right = DVector::zeros(size);
    right[0] = 1.0;
    let solved = system.lu().solve(&right);
    solved.expect("the eigenvalue 1 is simple").iter().copied().collect()
}

/// Pairs of a vertex and the diagonal of a tet's octahedron, where the vertex is
/// not on it.
fn diagonals(mesh: &TetMesh, topology: &Topology) -> Incidence {
    let states = mesh.features().map_or(&[][..], |features| &features.cell_states);
    let tets = mesh.tets().iter().zip(topology.tet_edges()).zip(states);
    let pairs = tets.flat_map(|((tet, edges), state)| {
        let diagonal = state.diagonal().map(|local| edges[local]);
        diagonal.into_iter().flat_map(|diagonal| {
            let ends = topology.edges()[diagonal as usize];
            tet.iter().filter(move |v| !ends.contains(v)).map(move |&v| [v, diagonal])
        })
    });
    Incidence::new(pairs.collect())
}
