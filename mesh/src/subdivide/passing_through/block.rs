//! Symmetric systems on a graph, with one vector of three components a vertex.

use rayon::prelude::*;

use crate::core::mirrors::Unfolded;
use octruss_base::chunks::map_ranges;
use octruss_base::large_array::filled;
use octruss_base::ragged::{CHUNK, accumulate};

/// Stands for a vertex that is no unknown.
const KNOWN: u32 = u32::MAX;

/// More iterations than a block with eigenvalues from 1/10 to 1 takes; graph Laplacians
/// of coarse meshes stay below, too.
const MOST_ITERATIONS: usize = 1_000;

/// The equations own_i x_i + sign Σ_j x_j = b_i over the neighbours j of i among the
/// unknowns; positive definite.
///
/// The unknowns are displacements. Beside mirror planes those of images are turned round:
/// across a plane, vertices on it are not displaced and their equations fall away; along
/// it an image counts as what it is an image of. Each equation is multiplied by the share
/// of its vertex, so that the matrix is symmetric: a vertex on a plane reads each
/// neighbour off it twice.
pub(super) struct Block<'a> {
    unfolded: &'a Unfolded<'a>,
    /// The vertices of the unknowns, ascending.
    pub vertices: Vec<u32>,
    own: Vec<f64>,
    signs: Vec<f64>,
    offsets: Vec<u32>,
    neighbours: Vec<u32>,
}

impl<'a> Block<'a> {
    /// Of these vertices of a mesh; `own` and `neighbours`, which are unfolded vertices,
    /// tell of each.
    pub fn new<I: Iterator<Item = u32>>(
        vertices: Vec<u32>,
        unfolded: &'a Unfolded,
        (own, sign): (impl Fn(u32) -> f64, f64),
        neighbours: impl Fn(u32) -> I,
    ) -> Self {
        let mut place = filled(KNOWN, unfolded.vertices());
        for (at, &vertex) in (0..).zip(&vertices) {
            place[vertex as usize] = at;
        }
        let (mut offsets, mut columns) = (vec![0], Vec::new());
        for &vertex in &vertices {
            let before = columns.len();
            let places = neighbours(vertex).map(|v| place[unfolded.original(v) as usize]);
            columns.extend(places.filter(|&at| at != KNOWN));
            offsets.push((columns.len() - before) as u32);
        }
        accumulate(&mut offsets);
        let own = vertices.iter().map(|&vertex| unfolded.share(vertex) * own(vertex)).collect();
        let signs = vertices.iter().map(|&vertex| unfolded.share(vertex) * sign).collect();
        Self { unfolded, vertices, own, signs, offsets, neighbours: columns }
    }

    /// Conjugate gradients from 0, preconditioned by the diagonal, until `is_small` holds
    /// for the residual of every unknown; and the number of iterations.
    pub fn solve(
        &self,
        rhs: Vec<[f64; 3]>,
        is_small: impl Fn(usize, [f64; 3]) -> bool + Sync,
    ) -> (Vec<[f64; 3]>, usize) {
        let n = rhs.len();
        let (mut x, mut residual) = (filled([0.0; 3], n), self.shared(&rhs));
        let mut direction = self.over_diagonal(&residual);
        let mut energy = dot(&residual, &direction);
        for iteration in 0..MOST_ITERATIONS {
            let all_small = residual.par_iter().with_min_len(CHUNK).enumerate();
            let whole = |i: usize, r: [f64; 3]| r.map(|r| r / self.share(i));
            if all_small.all(|(i, &r)| is_small(i, whole(i, r))) {
                return (self.along_axes(x), iteration);
            }
            let product = self.apply(&direction);
            let step = quotients(energy, dot(&direction, &product));
            add_multiple(&mut x, step, &direction);
            add_multiple(&mut residual, step.map(|s| -s), &product);
            let scaled = self.over_diagonal(&residual);
            let next = dot(&residual, &scaled);
            let keep = quotients(next, energy);
            let pairs = direction.par_iter_mut().with_min_len(CHUNK).zip(&scaled);
            pairs.for_each(|(p, z)| *p = std::array::from_fn(|k| z[k] + keep[k] * p[k]));
            energy = next;
        }
        (self.along_axes(x), MOST_ITERATIONS)
    }

    fn share(&self, unknown: usize) -> f64 {
        self.unfolded.share(self.vertices[unknown])
    }

    /// The right-hand side as the equations are: along the axes of mirror planes, shared.
    fn shared(&self, rhs: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let each = rhs.par_iter().with_min_len(CHUNK).enumerate();
        let shared = each.map(|(i, &b)| {
            self.free_part(i, self.unfolded.components(b).map(|b| self.share(i) * b))
        });
        shared.collect()
    }

    fn along_axes(&self, x: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
        x.into_par_iter().with_min_len(CHUNK).map(|x| self.unfolded.along_axes(x)).collect()
    }

    /// A vector without the components that an unknown has not.
    fn free_part(&self, unknown: usize, vector: [f64; 3]) -> [f64; 3] {
        let is_free = self.unfolded.is_free(self.vertices[unknown]);
        std::array::from_fn(|k| if is_free[k] { vector[k] } else { 0.0 })
    }

    fn over_diagonal(&self, r: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let pairs = r.par_iter().with_min_len(CHUNK).zip(&self.own);
        pairs.map(|(r, own)| r.map(|value| value / own)).collect()
    }

    fn apply(&self, x: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let row = |i: usize| {
            let range = self.offsets[i] as usize..self.offsets[i + 1] as usize;
            let mut sum = [0.0; 3];
            for &j in &self.neighbours[range] {
                (0..3).for_each(|k| sum[k] += x[j as usize][k]);
            }
            let row = |k: usize| self.own[i] * x[i][k] + self.signs[i] * sum[k];
            self.free_part(i, std::array::from_fn(row))
        };
        (0..x.len()).into_par_iter().with_min_len(CHUNK).map(row).collect()
    }
}

/// a / b, 0 where a component has nothing left to solve.
fn quotients(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| if b[k] > 0.0 { a[k] / b[k] } else { 0.0 })
}

/// The products of each component, summed by chunks.
fn dot(a: &[[f64; 3]], b: &[[f64; 3]]) -> [f64; 3] {
    let chunks = map_ranges(a.len(), |range| {
        let mut sum = [0.0; 3];
        for (a, b) in a[range.clone()].iter().zip(&b[range]) {
            (0..3).for_each(|k| sum[k] += a[k] * b[k]);
        }
        sum
    });
    chunks.iter().fold([0.0; 3], |sum, chunk| std::array::from_fn(|k| sum[k] + chunk[k]))
}

fn add_multiple(a: &mut [[f64; 3]], factor: [f64; 3], b: &[[f64; 3]]) {
    let pairs = a.par_iter_mut().with_min_len(CHUNK).zip(b);
    pairs.for_each(|(a, b)| (0..3).for_each(|k| a[k] += factor[k] * b[k]));
}
