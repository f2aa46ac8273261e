//! One subdivision step as a matrix.

use nalgebra_sparse::CsrMatrix;
use rayon::prelude::*;

use crate::chunks::CHUNK;
use crate::topology::Topology;

/// One subdivision step, n_fine × n_coarse in compressed rows; every row sums
/// to one.
///
/// Row i < n_coarse is the rule of coarse vertex i, row n_coarse + e that of
/// edge e. The same rows move points, carry point fields and prolong in
/// multigrid.
#[derive(Debug, Clone, PartialEq)]
pub struct SubdivisionMatrix {
    coarse_vertices: usize,
    offsets: Vec<u32>,
    columns: Vec<u32>,
    weights: Vec<f64>,
}

impl SubdivisionMatrix {
    /// Builds all rows in parallel: `fill(i, row)` adds the entries of row i.
    pub(crate) fn from_rows(
        rows: usize,
        coarse_vertices: usize,
        fill: impl Fn(usize, &mut Row) + Sync,
    ) -> Self {
        let chunks: Vec<RowChunk> = (0..rows.div_ceil(CHUNK))
            .into_par_iter()
            .map(|chunk| RowChunk::new(CHUNK * chunk..rows.min(CHUNK * (chunk + 1)), &fill))
            .collect();
        let nonzeros = chunks.iter().map(|chunk| chunk.columns.len()).sum();
        let mut matrix = Self {
            coarse_vertices,
            offsets: Vec::with_capacity(rows + 1),
            columns: Vec::with_capacity(nonzeros),
            weights: Vec::with_capacity(nonzeros),
        };
        matrix.offsets.push(0);
        for chunk in chunks {
            let before = matrix.columns.len() as u32;
            matrix.offsets.extend(chunk.ends.iter().map(|end| before + end));
            matrix.columns.extend_from_slice(&chunk.columns);
            matrix.weights.extend_from_slice(&chunk.weights);
        }
        matrix
    }

    /// How many rows: vertices of the fine mesh.
    pub fn rows(&self) -> usize {
        self.offsets.len() - 1
    }

    /// How many columns: vertices of the coarse mesh.
    pub fn columns(&self) -> usize {
        self.coarse_vertices
    }

    /// How many weights are stored.
    pub fn nonzeros(&self) -> usize {
        self.columns.len()
    }

    /// The memory that the matrix takes, in bytes.
    pub fn bytes(&self) -> usize {
        4 * self.offsets.len() + 12 * self.columns.len()
    }

    /// The columns of one row, ascending, and their weights.
    pub fn row(&self, row: usize) -> (&[u32], &[f64]) {
        let range = self.offsets[row] as usize..self.offsets[row + 1] as usize;
        (&self.columns[range.clone()], &self.weights[range])
    }

    /// The columns of one row and its weights, for changing them.
    pub(crate) fn row_mut(&mut self, row: usize) -> (&[u32], &mut [f64]) {
        let range = self.offsets[row] as usize..self.offsets[row + 1] as usize;
        (&self.columns[range.clone()], &mut self.weights[range])
    }

    /// Applies the step to points: one point a coarse vertex in, one a fine vertex out.
    pub fn apply<const N: usize>(&self, coarse: &[[f64; N]]) -> Vec<[f64; N]> {
        debug_assert_eq!(coarse.len(), self.coarse_vertices);
        let combine = |row| {
            let (columns, weights) = self.row(row);
            let mut sum = [0.0; N];
            for (&column, &weight) in columns.iter().zip(weights) {
                for (sum, value) in sum.iter_mut().zip(coarse[column as usize]) {
                    *sum += weight * value;
                }
            }
            sum
        };
        (0..self.rows()).into_par_iter().with_min_len(CHUNK).map(combine).collect()
    }

    /// Applies the step to a field with `components` values a vertex, vertex
    /// after vertex.
    ///
    /// # Panics
    /// If `coarse` does not have `components` values for each column.
    pub fn apply_field(&self, coarse: &[f64], components: usize) -> Vec<f64> {
        assert_eq!(coarse.len(), components * self.coarse_vertices, "one tuple a coarse vertex");
        let mut fine = vec![0.0; components * self.rows()];
        if components == 0 {
            return fine;
        }
        fine.par_chunks_mut(components).with_min_len(CHUNK).enumerate().for_each(|(row, sums)| {
            let (columns, weights) = self.row(row);
            for (&column, &weight) in columns.iter().zip(weights) {
                let values = &coarse[components * column as usize..][..components];
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        });
        fine
    }
}

/// The entries of one row while it is made; repeated columns add up.
#[derive(Default)]
pub(crate) struct Row {
    entries: Vec<(u32, f64)>,
}

impl Row {
    pub fn add(&mut self, column: u32, weight: f64) {
        self.entries.push((column, weight));
    }
}

/// A few thousand rows, made by one task.
struct RowChunk {
    ends: Vec<u32>,
    columns: Vec<u32>,
    weights: Vec<f64>,
}

impl RowChunk {
    fn new(rows: std::ops::Range<usize>, fill: &impl Fn(usize, &mut Row)) -> Self {
        let mut chunk =
            Self { ends: Vec::with_capacity(rows.len()), columns: Vec::new(), weights: Vec::new() };
        let mut row = Row::default();
        for number in rows {
            row.entries.clear();
            fill(number, &mut row);
            // Stable: repeated columns add up in the order they came.
            row.entries.sort_by_key(|entry| entry.0);
            for repeated in row.entries.chunk_by(|a, b| a.0 == b.0) {
                chunk.columns.push(repeated[0].0);
                chunk.weights.push(repeated.iter().map(|entry| entry.1).sum());
            }
            chunk.ends.push(chunk.columns.len() as u32);
        }
        chunk
    }
}

impl From<&SubdivisionMatrix> for CsrMatrix<f64> {
    /// The public form, for its ecosystem; 16 bytes an entry.
    fn from(matrix: &SubdivisionMatrix) -> Self {
        CsrMatrix::try_from_csr_data(
            matrix.rows(),
            matrix.coarse_vertices,
            matrix.offsets.iter().map(|&offset| offset as usize).collect(),
            matrix.columns.iter().map(|&column| column as usize).collect(),
            matrix.weights.clone(),
        )
        .expect("rows are sorted and free of duplicates")
    }
}

/// Linear interpolation on the red split: vertices stay, midpoints halve.
pub fn linear_matrix(topology: &Topology) -> SubdivisionMatrix {
    let n = topology.vertex_count();
    let edges = topology.edges();
    SubdivisionMatrix::from_rows(n + edges.len(), n, |row, entries| match row.checked_sub(n) {
        None => entries.add(row as u32, 1.0),
        Some(edge) => edges[edge].into_iter().for_each(|end| entries.add(end, 0.5)),
    })
}
