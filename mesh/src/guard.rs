//! Keeping quality: rows that would flatten tets are pulled back towards the
//! linear rule, as little as needed.
//!
//! The measure is η of the *lattice* of a tet: the smallest mean ratio among
//! the tet and all its descendants by red splits at midpoints, which fall into
//! three classes of shape (Bey 1995). A split by the linear rule keeps it, so
//! with every row linear no tet falls below its parent, and pulling back always
//! ends.

use rayon::prelude::*;

use crate::chunks::CHUNK;
use crate::raw_mesh::RawMesh;
use crate::red_split::Parents;
use crate::reference_tet::six_volumes;
use crate::subdivision_matrix::SubdivisionMatrix;

/// The shares of the linear rule that are tried are multiples of 1 / STEPS.
const STEPS: u8 = 32;

/// What the guard did in one step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GuardReport {
    /// The η that no tet falls below, unless its parent was below it.
    pub floor: f64,
    /// How many rows were pulled back.
    pub pulled_back: usize,
    /// How many of them all the way to the linear rule.
    pub linear: usize,
}

/// The smallest mean ratio among a tet and its descendants by red splits with
/// inherited marks; 0 or less if it is flat or inverted.
///
/// With e1 = x1 − x0, e2 = x2 − x1, e3 = x3 − x2 the three classes are the
/// lattice paths in cyclic orders of e1, e2, e3. All have the same volume, and
/// squared edges Σ|ei|² + |e1 + e2 + e3|² + two of the three |ei + ej|².
pub fn lattice_mean_ratio(corners: [[f64; 3]; 4]) -> f64 {
    let volume = six_volumes(corners);
    let [e1, e2, e3] = [0, 1, 2].map(|i| difference(corners[i + 1], corners[i]));
    let sums = [sum(e1, e2), sum(e2, e3), sum(e3, e1)].map(square);
    let least = sums[0].min(sums[1]).min(sums[2]);
    let squares = square(e1)
        + square(e2)
        + square(e3)
        + square(sum(sum(e1, e2), e3))
        + sums.iter().sum::<f64>()
        - least;
    // η = 12 (3 V)^(2/3) / Σ L² with six V at hand.
    12.0 * (0.25 * volume * volume).cbrt().copysign(volume) / squares
}

fn difference(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn sum(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [p[0] + q[0], p[1] + q[1], p[2] + q[2]]
}

fn square(p: [f64; 3]) -> f64 {
    p[0] * p[0] + p[1] * p[1] + p[2] * p[2]
}

/// A step as the guard sees it.
pub(crate) struct Guard<'a> {
    pub floor: f64,
    pub coarse: &'a RawMesh,
    pub coarse_edges: &'a [[u32; 2]],
    /// The coarse tets in the order that they are split in.
    pub parents: &'a Parents<'a>,
    pub fine_tets: &'a [[u32; 4]],
}

impl Guard<'_> {
    /// Pulls rows back until no tet is below the floor or its parent, and moves
    /// the points with them.
    pub fn apply(&self, matrix: &mut SubdivisionMatrix, points: &mut [[f64; 3]]) -> GuardReport {
        let smooth = points.to_vec();
        let mut shares = vec![0u8; points.len()];
        loop {
            let raised = self.raise(&smooth, &shares);
            if raised.is_empty() {
                break;
            }
            for (vertex, share) in raised {
                let current = &mut shares[vertex as usize];
                *current = share.max(*current);
                points[vertex as usize] = self.position(&smooth, vertex, *current);
            }
        }
        self.blend_rows(matrix, &shares);
        GuardReport {
            floor: self.floor,
            pulled_back: shares.iter().filter(|&&share| share > 0).count(),
            linear: shares.iter().filter(|&&share| share == STEPS).count(),
        }
    }

    /// For each tet that is too flat, the least share for its four vertices
    /// that mends it by itself.
    fn raise(&self, smooth: &[[f64; 3]], shares: &[u8]) -> Vec<(u32, u8)> {
        let mend = |(t, tet): (usize, &[u32; 4])| {
            let parent = self.parents.vertices(t / 8).map(|v| self.coarse.points[v as usize]);
            let quality = |least: u8| {
                let at = |v: u32| self.position(smooth, v, shares[v as usize].max(least));
                lattice_mean_ratio(tet.map(at))
            };
            // Rounding must not make a tet worse than a parent at the floor.
            let floor = self.floor.min(lattice_mean_ratio(parent)) * (1.0 - 1e-9);
            if quality(0) >= floor {
                return None;
            }
            let least = (1..STEPS).find(|&share| quality(share) >= floor).unwrap_or(STEPS);
            tet.iter().any(|&v| shares[v as usize] < least).then_some((*tet, least))
        };
        let bad: Vec<([u32; 4], u8)> =
            self.fine_tets.par_iter().with_min_len(CHUNK).enumerate().filter_map(mend).collect();
        bad.into_iter().flat_map(|(tet, share)| tet.map(|v| (v, share))).collect()
    }

    /// Where a fine vertex is with a share of the linear rule.
    fn position(&self, smooth: &[[f64; 3]], vertex: u32, share: u8) -> [f64; 3] {
        let moved = smooth[vertex as usize];
        if share == 0 {
            return moved;
        }
        let linear = self.linear_position(vertex as usize);
        let t = f64::from(share) / f64::from(STEPS);
        std::array::from_fn(|k| (1.0 - t) * moved[k] + t * linear[k])
    }

    fn linear_position(&self, vertex: usize) -> [f64; 3] {
        match vertex.checked_sub(self.coarse.points.len()) {
            None => self.coarse.points[vertex],
            Some(edge) => {
                let [p, q] = self.coarse_edges[edge].map(|v| self.coarse.points[v as usize]);
                std::array::from_fn(|k| 0.5 * (p[k] + q[k]))
            }
        }
    }

    fn blend_rows(&self, matrix: &mut SubdivisionMatrix, shares: &[u8]) {
        for (row, &share) in shares.iter().enumerate().filter(|(_, share)| **share > 0) {
            let t = f64::from(share) / f64::from(STEPS);
            let (columns, weights) = matrix.row_mut(row);
            weights.iter_mut().for_each(|weight| *weight *= 1.0 - t);
            let mut add = |column: u32, weight: f64| {
                let at =
                    columns.binary_search(&column).expect("a rule reads its own vertex or ends");
                weights[at] += weight;
            };
            match row.checked_sub(self.coarse.points.len()) {
                None => add(row as u32, t),
                Some(edge) => self.coarse_edges[edge].into_iter().for_each(|end| add(end, 0.5 * t)),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quality::mean_ratio;
    use crate::reference_tet::{CHILDREN, EDGES};

    fn node(corners: [[f64; 3]; 4], n: usize) -> [f64; 3] {
        if n < 4 {
            return corners[n];
        }
        let [a, b] = EDGES[n - 4];
        std::array::from_fn(|k| 0.5 * (corners[a][k] + corners[b][k]))
    }

    /// The smallest mean ratio within some splits, by splitting.
    fn slow(corners: [[f64; 3]; 4], levels: u32) -> f64 {
        let own = mean_ratio(corners);
        if levels == 0 {
            return own;
        }
        CHILDREN
            .iter()
            .map(|child| slow(child.map(|n| node(corners, n)), levels - 1))
            .fold(own, f64::min)
    }

    #[test]
    fn the_lattice_measure_is_that_of_all_descendants() {
        let tets = [
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            [[0.0, 0.1, 0.0], [1.0, 0.3, 0.2], [0.2, 1.5, 0.1], [0.4, 0.3, 2.0]],
            [[3.0, 0.1, 0.0], [1.0, 0.3, 0.2], [0.2, 1.5, 0.1], [0.4, 0.3, -2.0]],
        ];
        for mut corners in tets {
            if six_volumes(corners) < 0.0 {
                corners.swap(0, 2);
            }
            let fast = lattice_mean_ratio(corners);
            assert!((fast - slow(corners, 3)).abs() < 1e-14);
            for child in CHILDREN {
                assert!((lattice_mean_ratio(child.map(|n| node(corners, n))) - fast).abs() < 1e-13);
            }
            corners.swap(0, 1);
            assert!(lattice_mean_ratio(corners) < 0.0);
        }
    }
}
