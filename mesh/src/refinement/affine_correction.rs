//! Rows of a prolongation made exact for linear functions.
//!
//! A matrix that did not make the fine geometry misses x_f: Σ w x_c ≠ x_f. Then
//! linear functions, and for elasticity the rotations, are not in its range. Each
//! such row gets the smallest change δ, measured by Σ δ² / |w|, with Σ δ = 0 and
//! Σ δ x_c = x_f − Σ w x_c. With the mean c of the columns, weighted by |w|, that is
//! δ = |w| λ · (x_c − c), where the 3 × 3 matrix Σ |w| (x_c − c)(x_c − c)ᵀ takes λ to
//! the miss. Columns on a line or in a plane may not reach x_f; the smallest change
//! may be a large one. Then the linear rule is tried, and last the support is
//! extended by the vertices of the tets round the coarse vertex or edge, if need be
//! by further rings of neighbours.

use nalgebra::{Cholesky, Matrix3, SymmetricEigen, Vector3};
use rayon::prelude::*;

use crate::core::mirrors::Unfolded;
use crate::core::topology::{EdgeFaces, VertexEdges};
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use octruss_base::ragged::CHUNK;

/// Which rows of a prolongation are made exact for linear functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AffineCorrection {
    /// Every row that needs it, where the affine defect of the transfer exceeds
    /// [`NEGLIGIBLE_DEFECT`]. Linear interpolation stays what it is.
    #[default]
    Auto,
    /// Every row that needs it, also of linear interpolation.
    On,
    /// None.
    Off,
}

impl AffineCorrection {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::Auto, Self::On, Self::Off];

    /// The name by which configurations call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::On => "on",
            Self::Off => "off",
        }
    }
}

/// An affine defect, in mean edge lengths, that is rounding.
pub const NEGLIGIBLE_DEFECT: f64 = 1e-8;

/// A miss, in mean edge lengths, with which a row counts as exact...
const EXACT: f64 = 1e-12;

/// ... or in roundings of the largest coordinate.
const ROUNDINGS: f64 = 32.0;

/// The largest Σ |w| of a changed row: beyond, it would amplify noise.
const LARGEST_SUM: f64 = 3.0;

/// How far a support is extended: a tet at the rim of a body may be too thin to reach
/// x_f with moderate weights, its neighbours are not.
const MOST_RINGS: usize = 3;

/// Directions in which columns spread less than this, against the most, are none:
/// moving x_f along them would take weights of this size's inverse root.
const FLAT: f64 = 1e-8;

/// Pivots above this share of the trace: all eigenvalues are then far above [`FLAT`].
const WELL_SPREAD: f64 = 1e-3;

/// How rows were made exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CorrectedRows {
    /// Changed on their own support.
    pub corrected: usize,
    /// Replaced by the linear rule.
    pub replaced: usize,
    /// Extended by the vertices of the tets around, and changed.
    pub extended: usize,
    /// Left as they were, since nothing helped.
    pub left: usize,
}

/// Two meshes, a step apart.
#[derive(Clone, Copy)]
pub(crate) struct Geometry<'a> {
    coarse: &'a Unfolded<'a>,
    fine: &'a [[f64; 3]],
    /// The miss up to which a row is exact, in mesh units.
    tolerance: f64,
}

/// The matrix with every row made exact that is not, and how.
pub(crate) fn corrected(
    matrix: &SubdivisionMatrix,
    geometry: &Geometry,
) -> (SubdivisionMatrix, CorrectedRows) {
    let correction = Correction::new(geometry);
    let rows = 0..matrix.rows();
    let inexact: Vec<usize> = rows
        .into_par_iter()
        .with_min_len(CHUNK)
        .filter(|&row| !geometry.is_exact(row, matrix.row(row)))
        .collect();
    let changes: Vec<Change> =
        inexact.par_iter().map(|&row| correction.change(row, matrix.row(row))).collect();
    let count = |how: How| changes.iter().filter(|change| change.how == how).count();
    let counts = CorrectedRows {
        corrected: count(How::Corrected),
        replaced: count(How::Replaced),
        extended: count(How::Extended),
        left: count(How::Left),
    };
    let corrected =
        SubdivisionMatrix::from_rows(matrix.rows(), matrix.columns(), |row, entries| {
            let (columns, weights) = match inexact.binary_search(&row) {
                Ok(at) => (&*changes[at].columns, &*changes[at].weights),
                Err(_) => matrix.row(row),
            };
            columns.iter().zip(weights).for_each(|(&column, &weight)| entries.add(column, weight));
        });
    (corrected, counts)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum How {
    Corrected,
    Replaced,
    Extended,
    Left,
}

/// A row in place of an inexact one.
struct Change {
    how: How,
    columns: Vec<u32>,
    weights: Vec<f64>,
}

impl<'a> Geometry<'a> {
    /// `length` is the mean of the coarse mesh's edges; columns are unfolded vertices.
    pub fn new(coarse: &'a Unfolded<'a>, fine: &'a [[f64; 3]], length: f64) -> Self {
        let coordinates = coarse.mesh.points.as_flattened().par_iter();
        let extent = coordinates.map(|x| x.abs()).reduce(|| 0.0, f64::max);
        let tolerance = EXACT * length + ROUNDINGS * f64::EPSILON * extent;
        Self { coarse, fine, tolerance }
    }

    /// A coarse vertex as seen from the fine one of a row.
    fn arm(&self, row: usize, column: u32) -> Vector3<f64> {
        Vector3::from(self.coarse.mesh.points[column as usize]) - Vector3::from(self.fine[row])
    }

    /// The coarse edge that a row is for; none if it is for a vertex.
    fn edge(&self, row: usize) -> Option<u32> {
        row.checked_sub(self.coarse.vertices()).map(|edge| self.coarse.edge(edge))
    }

    /// x_f − Σ w x_c, for weights that sum to one.
    fn miss(&self, row: usize, (columns, weights): (&[u32], &[f64])) -> Vector3<f64> {
        let terms = columns.iter().zip(weights);
        -terms.map(|(&column, &weight)| weight * self.arm(row, column)).sum::<Vector3<f64>>()
    }

    fn is_exact(&self, row: usize, weights: (&[u32], &[f64])) -> bool {
        self.miss(row, weights).amax() <= self.tolerance
    }
}

struct Correction<'a> {
    geometry: &'a Geometry<'a>,
    vertex_edges: VertexEdges,
    edge_faces: EdgeFaces<'a>,
}

impl<'a> Correction<'a> {
    fn new(geometry: &'a Geometry<'a>) -> Self {
        let topology = &*geometry.coarse.topology;
        let (vertex_edges, edge_faces) = (VertexEdges::new(topology), EdgeFaces::new(topology));
        Self { geometry, vertex_edges, edge_faces }
    }

    fn change(&self, row: usize, (columns, weights): (&[u32], &[f64])) -> Change {
        let (own, own_weights) = (columns.to_vec(), weights.to_vec());
        let sizes: Vec<f64> = weights.iter().map(|weight| weight.abs()).collect();
        if let Some(weights) = self.nearest(row, (columns, weights), &sizes) {
            return Change { how: How::Corrected, columns: own, weights };
        }
        let (linear_columns, linear_weights) = self.linear(row);
        if self.geometry.is_exact(row, (&linear_columns, &linear_weights)) {
            return Change { how: How::Replaced, columns: linear_columns, weights: linear_weights };
        }
        let mut wide = self.around(row);
        for _ in 0..MOST_RINGS {
            wide.extend(columns);
            wide.sort_unstable();
            wide.dedup();
            let weights = weights_of(&wide, (columns, weights));
            // All columns may change alike: those that the rule leaves out, too.
            let share = 1.0 / wide.len() as f64;
            let sizes: Vec<f64> = weights.iter().map(|weight| weight.abs() + share).collect();
            if let Some(weights) = self.nearest(row, (&wide, &weights), &sizes) {
                return Change { how: How::Extended, columns: wide, weights };
            }
            wide = wide.iter().flat_map(|&vertex| self.around_vertex(vertex)).collect();
        }
        Change { how: How::Left, columns: own, weights: own_weights }
    }

    /// The weights nearest to these that are exact, if any of moderate size are.
    fn nearest(
        &self,
        row: usize,
        (columns, weights): (&[u32], &[f64]),
        sizes: &[f64],
    ) -> Option<Vec<f64>> {
        let geometry = self.geometry;
        let total: f64 = sizes.iter().sum();
        let arms: Vec<_> = columns.iter().map(|&column| geometry.arm(row, column)).collect();
        let weighted = arms.iter().zip(sizes).map(|(arm, size)| *size * arm);
        let centre = weighted.sum::<Vector3<f64>>() / total;
        let spread = |(arm, size): (&Vector3<f64>, &f64)| {
            let from_centre = arm - centre;
            *size * from_centre * from_centre.transpose()
        };
        let moments: Matrix3<f64> = arms.iter().zip(sizes).map(spread).sum();
        let lambda = solved(moments, geometry.miss(row, (columns, weights)))?;
        let changed = weights.iter().zip(arms.iter().zip(sizes));
        let changed: Vec<f64> = changed
            .map(|(weight, (arm, size))| weight + size * lambda.dot(&(arm - centre)))
            .collect();
        let sum: f64 = changed.iter().map(|weight| weight.abs()).sum();
        (geometry.is_exact(row, (columns, &changed)) && sum <= LARGEST_SUM).then_some(changed)
    }

    /// The rule of linear interpolation.
    fn linear(&self, row: usize) -> (Vec<u32>, Vec<f64>) {
        match self.geometry.edge(row) {
            None => (vec![row as u32], vec![1.0]),
            Some(edge) => (self.ends(edge).to_vec(), vec![0.5; 2]),
        }
    }

    fn ends(&self, edge: u32) -> [u32; 2] {
        self.geometry.coarse.topology.edges()[edge as usize]
    }

    /// The vertices of all tets at the coarse vertex or edge of a row.
    fn around(&self, row: usize) -> Vec<u32> {
        match self.geometry.edge(row) {
            None => self.around_vertex(row as u32),
            Some(edge) => self.ends(edge).into_iter().chain(self.edge_faces.thirds(edge)).collect(),
        }
    }

    fn around_vertex(&self, vertex: u32) -> Vec<u32> {
        let at_vertex = self.vertex_edges.of(vertex as usize).iter();
        at_vertex.flat_map(|&edge| self.ends(edge)).chain([vertex]).collect()
    }
}

/// The weights of some columns in a row; 0 where it has none.
fn weights_of(columns: &[u32], (of_row, weights): (&[u32], &[f64])) -> Vec<f64> {
    let weight = |column| of_row.binary_search(column).map_or(0.0, |at| weights[at]);
    columns.iter().map(weight).collect()
}

/// λ with `moments` λ = miss in the directions that the matrix spreads in; none if there is
/// no such direction.
fn solved(moments: Matrix3<f64>, miss: Vector3<f64>) -> Option<Vector3<f64>> {
    // Nearly all spread in space: pivots are within the spectrum, and cost far less than it.
    if let Some(factor) = Cholesky::new(moments) {
        let pivots = factor.l_dirty().diagonal();
        if pivots.min().powi(2) > WELL_SPREAD * moments.trace() {
            return Some(factor.solve(&miss));
        }
    }
    Some(pseudo_inverse(moments)? * miss)
}

/// The inverse on the directions that a matrix of second moments spreads in; none if
/// there is no such direction.
fn pseudo_inverse(moments: Matrix3<f64>) -> Option<Matrix3<f64>> {
    let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(moments);
    let most = eigenvalues.amax();
    (most > 0.0).then(|| {
        let inverse = |value: f64| if value > FLAT * most { value.recip() } else { 0.0 };
        eigenvectors * Matrix3::from_diagonal(&eigenvalues.map(inverse)) * eigenvectors.transpose()
    })
}
