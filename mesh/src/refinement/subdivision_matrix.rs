//! One subdivision step as a matrix.

use nalgebra_sparse::CsrMatrix;
use rayon::prelude::*;

use crate::core::topology::Topology;
use octruss_base::large_array::{filled, zeroed};
use octruss_base::ragged::{CHUNK, accumulate};

/// One subdivision step, n_fine × n_coarse in compressed rows; every row sums
/// to one.
///
/// Row i < n_coarse is the rule of coarse vertex i, row n_coarse + e that of
/// edge e; if only some edges were split, of the e-th of these. The same rows move points, carry point fields and prolong in
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
        let mut starts = vec![0];
        starts.extend(chunks.iter().map(|chunk| chunk.columns.len() as u32));
        accumulate(&mut starts);
        let nonzeros = starts[chunks.len()] as usize;
        let mut matrix = Self {
            coarse_vertices,
            offsets: zeroed(rows + 1),
            columns: zeroed(nonzeros),
            weights: zeroed(nonzeros),
        };
        let (mut columns, mut weights) = (&mut matrix.columns[..], &mut matrix.weights[..]);
        let parts = matrix.offsets[1..].chunks_mut(CHUNK).zip(&chunks).zip(&starts);
        let parts: Vec<_> = parts
            .map(|((offsets, chunk), &start)| {
                let count = chunk.columns.len();
                (
                    offsets,
                    chunk,
                    start,
                    split_off(&mut columns, count),
                    split_off(&mut weights, count),
                )
            })
            .collect();
        parts.into_par_iter().for_each(|(offsets, chunk, start, columns, weights)| {
            for (offset, end) in offsets.iter_mut().zip(&chunk.ends) {
                *offset = start + end;
            }
            columns.copy_from_slice(&chunk.columns);
            weights.copy_from_slice(&chunk.weights);
        });
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
        let zero = [0.0; N];
        let combine = |row| {
            let (columns, weights) = self.row(row);
            let mut sum = zero;
            for (&column, &weight) in columns.iter().zip(weights) {
                for (sum, value) in sum.iter_mut().zip(coarse[column as usize]) {
                    *sum += weight * value;
                }
            }
            sum
        };
        let mut fine = filled(zero, self.rows());
        let rows = fine.par_iter_mut().with_min_len(CHUNK).enumerate();
        rows.for_each(|(row, value)| *value = combine(row));
        fine
    }

    /// Applies the step to a field with `components` values a vertex, vertex
    /// after vertex.
    ///
    /// # Panics
    /// If `coarse` does not have `components` values for each column.
    pub fn apply_field(&self, coarse: &[f64], components: usize) -> Vec<f64> {
        assert_eq!(coarse.len(), components * self.coarse_vertices, "one tuple a coarse vertex");
        let mut fine = filled(0.0, components * self.rows());
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

/// The first `count` entries of a slice, which keeps the rest.
fn split_off<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let (first, rest) = std::mem::take(slice).split_at_mut(count);
    *slice = rest;
    first
}

/// One row while it is made, columns ascending; repeated columns add up in the
/// order they come.
pub(crate) struct Row<'a> {
    columns: &'a mut Vec<u32>,
    weights: &'a mut Vec<f64>,
    start: usize,
}

impl Row<'_> {
    /// Adds a weight; cheapest if columns come in ascending order.
    #[inline]
    pub fn add(&mut self, column: u32, weight: f64) {
        let own = &self.columns[self.start..];
        match own.last() {
            Some(&last) if last >= column => {
                let after = own.iter().rev().take_while(|&&other| other > column).count();
                self.insert(self.columns.len() - after, column, weight);
            }
            _ => {
                self.columns.push(column);
                self.weights.push(weight);
            }
        }
    }

    fn insert(&mut self, at: usize, column: u32, weight: f64) {
        if at > self.start && self.columns[at - 1] == column {
            self.weights[at - 1] += weight;
        } else {
            self.columns.insert(at, column);
            self.weights.insert(at, weight);
        }
    }
}

/// As many entries as few schemes exceed in the mean of many rows.
const USUAL_WIDTH: usize = 8;

/// A few thousand rows, made by one task.
struct RowChunk {
    ends: Vec<u32>,
    columns: Vec<u32>,
    weights: Vec<f64>,
}

impl RowChunk {
    fn new(rows: std::ops::Range<usize>, fill: &impl Fn(usize, &mut Row)) -> Self {
        let (ends, entries) = (Vec::with_capacity(rows.len()), USUAL_WIDTH * rows.len());
        let (columns, weights) = (Vec::with_capacity(entries), Vec::with_capacity(entries));
        let mut chunk = Self { ends, columns, weights };
        for number in rows {
            let start = chunk.columns.len();
            let mut row = Row { columns: &mut chunk.columns, weights: &mut chunk.weights, start };
            fill(number, &mut row);
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
    let edges = topology.edges();
    midpoint_rows(topology.vertex_count(), edges.len(), |edge| edges[edge])
}

/// Linear interpolation where only these edges are split: vertices stay, midpoints halve.
pub(crate) fn midpoint_matrix(topology: &Topology, split_edges: &[u32]) -> SubdivisionMatrix {
    let edges = topology.edges();
    let ends = |place: usize| edges[split_edges[place] as usize];
    midpoint_rows(topology.vertex_count(), split_edges.len(), ends)
}

fn midpoint_rows(
    vertices: usize,
    midpoints: usize,
    ends: impl Fn(usize) -> [u32; 2] + Sync,
) -> SubdivisionMatrix {
    let rows = vertices + midpoints;
    SubdivisionMatrix::from_rows(rows, vertices, |row, entries| match row.checked_sub(vertices) {
        None => entries.add(row as u32, 1.0),
        Some(midpoint) => ends(midpoint).into_iter().for_each(|end| entries.add(end, 0.5)),
    })
}
