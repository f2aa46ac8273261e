//! Keeping quality: rows that would flatten tets are pulled back towards the
//! linear rule, as little as needed.
//!
//! The measure is η of the *lattice* of a tet: the smallest mean ratio among
//! the tet and all its descendants by red splits at midpoints, which fall into
//! three classes of shape (Bey 1995). A split by the linear rule keeps it, so
//! with every row linear no tet falls below its parent, and pulling back always
//! ends. Where each level chooses its diagonals anew, a tet keeps its marked one
//! if another would begin a lattice below the floor.

use rayon::prelude::*;

use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::{MARKING_PERMUTATIONS, corners, six_volumes};
use crate::core::tet_mesh::TetMesh;
use crate::refinement::guard_report::GuardReport;
use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use crate::soundness::quality::smallest_mean_ratio;
use crate::subdivide::red_split::parents::Parents;
use crate::subdivide::red_split::parts::{PARTS, child_of, families, parent_of};
use octruss_base::ragged::CHUNK;
use octruss_base::vector3::{add, dot3, subtract};

/// The shares of the linear rule that are tried are multiples of 1 / STEPS.
const STEPS: u8 = 32;

/// The floor that serves where none is chosen: half of the smallest mean ratio
/// that the mesh began with, as its features record it, or has now.
pub fn usual_floor(mesh: &TetMesh) -> f64 {
    let recorded = mesh.features().and_then(|features| features.initial_quality);
    0.5 * recorded.unwrap_or_else(|| smallest_mean_ratio(mesh.raw()))
}

/// The smallest mean ratio among a tet and its descendants by red splits with
/// inherited marks; 0 or less if it is flat or inverted.
pub fn lattice_mean_ratio(corners: [[f64; 3]; 4]) -> f64 {
    Lattice::new(corners).mean_ratio()
}

/// What the mean ratio of a tet's lattice is made of.
///
/// With e1 = x1 − x0, e2 = x2 − x1, e3 = x3 − x2 the three classes of
/// descendants are the lattice paths in cyclic orders of e1, e2, e3. All have
/// the same volume, and squared edges Σ|ei|² + |e1 + e2 + e3|² + two of the
/// three |ei + ej|².
struct Lattice {
    /// Six times the volume.
    volume: f64,
    /// The greatest sum of squared edges.
    squares: f64,
}

impl Lattice {
    #[inline]
    fn new(corners: [[f64; 3]; 4]) -> Self {
        let [x0, x1, x2, x3] = corners;
        let (e1, e2, e3) = (subtract(x1, x0), subtract(x2, x1), subtract(x3, x2));
        let square = |p| dot3(p, p);
        let (s12, s23, s31) = (square(add(e1, e2)), square(add(e2, e3)), square(add(e3, e1)));
        let ends = square(e1) + square(e2) + square(e3) + square(add(add(e1, e2), e3));
        let squares = ends + s12 + s23 + s31 - s12.min(s23).min(s31);
        Self { volume: six_volumes(corners), squares }
    }

    fn mean_ratio(&self) -> f64 {
        let Self { volume, squares } = self;
        // η = 12 (3 V)^(2/3) / Σ L² with six V at hand.
        12.0 * (0.25 * volume * volume).cbrt().copysign(*volume) / squares
    }

    /// Whether η is at least `floor` > 0: compared as cubes, which need no root.
    #[inline]
    fn is_at_least(&self, floor: f64) -> bool {
        let allowed = floor * self.squares / 12.0;
        self.volume > 0.0 && 0.25 * self.volume * self.volume >= allowed * allowed * allowed
    }
}

/// Puts tets that are to be split along these pairs back to their marked one
/// where the pair's lattice is below the floor and the marked one's is better.
pub(crate) fn keep_above(floor: f64, coarse: &RawMesh, pairs: &mut [u8]) {
    let ratio = |tet: usize, pair: usize| {
        let corners = corners(&coarse.points, coarse.tets[tet]);
        lattice_mean_ratio(MARKING_PERMUTATIONS[pair].map(|v| corners[v]))
    };
    pairs.par_iter_mut().with_min_len(CHUNK).enumerate().for_each(|(tet, pair)| {
        if *pair != 0 && ratio(tet, usize::from(*pair)) < floor.min(ratio(tet, 0)) {
            *pair = 0;
        }
    });
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

/// What a guard did.
pub(crate) struct Pulls {
    /// The share of the linear rule, in [`STEPS`], of each fine vertex; empty if all is
    /// as it was.
    pub shares: Vec<u8>,
    pub report: GuardReport,
}

impl Guard<'_> {
    /// Pulls rows back until no tet is below the floor or its parent, and moves
    /// the points with them.
    pub fn apply(&self, matrix: &mut SubdivisionMatrix, points: &mut [[f64; 3]]) -> GuardReport {
        let Pulls { shares, report } = self.pull_back(points);
        self.blend_rows(matrix, &shares);
        report
    }

    /// The same for points that are no rows of a matrix.
    pub fn pull_back(&self, points: &mut [[f64; 3]]) -> Pulls {
        let mut report = GuardReport { floor: self.floor, ..GuardReport::default() };
        let mut bad = self.too_flat(points, |_| true);
        if bad.is_empty() {
            return Pulls { shares: Vec::new(), report };
        }
        let smooth = points.to_vec();
        let mut shares = vec![0u8; points.len()];
        while !bad.is_empty() {
            let mut moved = vec![false; points.len()];
            for (tet, share) in self.raise(&bad, &smooth, &shares) {
                for vertex in tet.map(|v| v as usize) {
                    if shares[vertex] < share {
                        shares[vertex] = share;
                        points[vertex] = self.position(&smooth, vertex, share);
                        moved[vertex] = true;
                    }
                }
            }
            bad = self.too_flat(points, |tet| tet.iter().any(|&v| moved[v as usize]));
        }
        report.pulled_back = shares.iter().filter(|&&share| share > 0).count();
        report.linear = shares.iter().filter(|&&share| share == STEPS).count();
        Pulls { shares, report }
    }

    /// The tets below what they must reach, among those asked for.
    fn too_flat(
        &self,
        points: &[[f64; 3]],
        asked_for: impl Fn(&[u32; 4]) -> bool + Sync,
    ) -> Vec<u32> {
        let bad = |(parent, children): (usize, &[[u32; 4]; PARTS])| {
            // Nearly all are above the floor itself, whatever the parent.
            let below = |tet: &[u32; 4]| {
                asked_for(tet) && !Lattice::new(corners(points, *tet)).is_at_least(self.floor)
            };
            let mut bad = [false; PARTS];
            if children.iter().any(below) {
                let floor = self.floor_within(parent);
                for (bad, tet) in bad.iter_mut().zip(children) {
                    let is_fine = Lattice::new(corners(points, *tet)).is_at_least(floor);
                    *bad = asked_for(tet) && !is_fine;
                }
            }
            let bad = (0..PARTS).filter(move |&child| bad[child]);
            bad.map(move |child| child_of(parent as u32, child as u32))
        };
        let children = families(self.fine_tets).par_iter();
        children.with_min_len(CHUNK).enumerate().flat_map_iter(bad).collect()
    }

    /// What the children of a tet must reach. Rounding must not make one worse
    /// than a parent at the floor.
    fn floor_within(&self, parent: usize) -> f64 {
        let corners = corners(&self.coarse.points, self.parents.vertices(parent));
        self.floor.min(lattice_mean_ratio(corners)) * (1.0 - 1e-9)
    }

    /// For each tet that is too flat, its vertices and the least share for all
    /// of them that mends it by itself.
    fn raise(&self, bad: &[u32], smooth: &[[f64; 3]], shares: &[u8]) -> Vec<([u32; 4], u8)> {
        let mend = |&t: &u32| {
            let tet = self.fine_tets[t as usize];
            let floor = self.floor_within(parent_of(t) as usize);
            let mends = |least: &u8| {
                let at = |v: u32| self.position(smooth, v as usize, shares[v as usize].max(*least));
                Lattice::new(tet.map(at)).is_at_least(floor)
            };
            (tet, (1..STEPS).find(mends).unwrap_or(STEPS))
        };
        bad.par_iter().map(mend).collect()
    }

    /// Where a fine vertex is with a share of the linear rule.
    fn position(&self, smooth: &[[f64; 3]], vertex: usize, share: u8) -> [f64; 3] {
        let moved = smooth[vertex];
        if share == 0 {
            return moved;
        }
        let linear = self.linear_position(vertex);
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
    use crate::core::reference_tet::{CHILDREN, EDGES};
    use crate::soundness::quality::mean_ratio;

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
