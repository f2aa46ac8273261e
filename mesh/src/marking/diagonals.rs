//! Comparing the three diagonals that can split a tet.

use rayon::prelude::*;

use crate::core::raw_mesh::RawMesh;
use crate::core::reference_tet::{MARKING_PERMUTATIONS, corners};
use octruss_base::ragged::CHUNK;

/// Diagonals whose squared lengths differ relatively by less than this are equal.
const TIE: f64 = 1e-9;

/// For each pair (as in [`MARKING_PERMUTATIONS`]) how many of the other two have
/// a shorter diagonal.
pub(super) fn ranks(corners: [[f64; 3]; 4]) -> [u8; 3] {
    let length = |pair: usize| {
        let [a, b, c, d] = MARKING_PERMUTATIONS[pair].map(|v| corners[v]);
        (0..3).map(|k| (a[k] + c[k] - b[k] - d[k]).powi(2)).sum::<f64>()
    };
    let lengths: [f64; 3] = std::array::from_fn(length);
    lengths.map(|own| lengths.iter().filter(|&&other| other * (1.0 + TIE) < own).count() as u8)
}

/// For each tet the pair with the shortest diagonal; ties go to the pair at hand.
pub(crate) fn shortest_pairs(mesh: &RawMesh) -> Vec<u8> {
    let shortest = |&tet: &[u32; 4]| shortest_pair(corners(&mesh.points, tet));
    mesh.tets.par_iter().with_min_len(CHUNK).map(shortest).collect()
}

/// The pair of one tet with the shortest diagonal; ties go to the pair at hand.
pub(crate) fn shortest_pair(corners: [[f64; 3]; 4]) -> u8 {
    // None is shortest only if a coordinate is no number.
    ranks(corners).iter().position(|&rank| rank == 0).unwrap_or(0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::shapes::{five_tet_cube, kuhn_cube};

    #[test]
    fn the_shortest_diagonal_is_found_whatever_the_order() {
        // A tet long in z: the closest opposite edges are the two long ones.
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, 0.0], [0.1, 0.0, 5.0], [0.0, 1.3, 5.5]];
        for order in MARKING_PERMUTATIONS {
            let moved = order.map(|v| corners[v]);
            let mut sorted = ranks(moved);
            let pair = sorted.iter().position(|&rank| rank == 0).unwrap();
            sorted.sort_unstable();
            assert_eq!(sorted, [0, 1, 2]);
            let [a, b, c, d] = MARKING_PERMUTATIONS[pair].map(|v| moved[v]);
            let mid = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|k| 0.5 * (p[k] + q[k]));
            let distance = nalgebra::distance(&mid(a, c).into(), &mid(b, d).into());
            let all = [[0, 1, 2, 3], [0, 2, 1, 3], [0, 3, 1, 2]].map(|[p, q, r, s]: [usize; 4]| {
                nalgebra::distance(
                    &mid(corners[p], corners[q]).into(),
                    &mid(corners[r], corners[s]).into(),
                )
            });
            assert!((distance - all.into_iter().fold(f64::INFINITY, f64::min)).abs() < 1e-14);
        }
    }

    #[test]
    fn a_tie_goes_to_the_pair_at_hand() {
        // All three tie in the regular tet; in a Kuhn tet the marked pair ties
        // with one other, and the third, of squared length 6 against 2, is last.
        assert_eq!(ranks(five_tet_cube().corners(0)), [0, 0, 0]);
        assert_eq!(shortest_pairs(five_tet_cube().raw()), [0; 5]);
        assert_eq!(ranks(kuhn_cube(1).corners(0)), [0, 2, 0]);
        assert_eq!(shortest_pairs(kuhn_cube(1).raw()), [0; 6]);
    }
}
