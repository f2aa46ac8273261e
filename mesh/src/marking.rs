//! Choosing the marked pair of each initial tet.

use crate::raw_mesh::RawMesh;
use crate::reference_tet::{EDGES, FACES, MARKED, MARKING_PERMUTATIONS, edge_between};
use crate::topology::{NONE, Topology};

/// Diagonals whose squared lengths differ relatively by less than this are equal.
const TIE: f64 = 1e-9;

/// Reorders each tet by an even permutation so that its inner diagonal, between
/// the midpoints of the marked pair, is the shortest of the three.
///
/// Ties go to the pair that agrees with most neighbours already marked, then to
/// the order at hand. A shortest diagonal keeps the children's shapes best
/// ([Bey 1995], and Wang's thesis, section 3.1); agreement across faces keeps
/// the lattice of the box-spline scheme regular there.
///
/// [Bey 1995]: https://doi.org/10.1007/BF02238487
pub fn mark_shortest(mesh: &mut RawMesh, topology: &Topology) {
    let candidates: Vec<Vec<usize>> =
        mesh.tets.iter().map(|tet| shortest_pairs(tet.map(|v| mesh.points[v as usize]))).collect();
    // The marked edge of each face as its two tets see it; unknown so far.
    let mut marked_edges = vec![[NONE; 2]; topology.faces().len()];
    let (clear, tied): (Vec<usize>, Vec<usize>) =
        (0..mesh.tets.len()).partition(|&t| candidates[t].len() == 1);
    for t in clear.into_iter().chain(tied) {
        let agreement = |pair: usize| {
            (0..4)
                .filter(|&f| {
                    let face = topology.tet_faces()[t][f] as usize;
                    marked_edges[face].contains(&marked_edge(topology, t, f, pair))
                })
                .count()
        };
        let pair = *candidates[t]
            .iter()
            .max_by_key(|&&pair| (agreement(pair), std::cmp::Reverse(pair)))
            .expect("one of three diagonals is shortest");
        for f in 0..4 {
            let face = topology.tet_faces()[t][f] as usize;
            let side = usize::from(topology.face_tets()[face][0] != t as u32);
            marked_edges[face][side] = marked_edge(topology, t, f, pair);
        }
        let order = MARKING_PERMUTATIONS[pair];
        mesh.tets[t] = order.map(|v| mesh.tets[t][v]);
    }
}

/// The edge that a tet would mark in its local face f under a choice of pair.
/// The numbering is the topology's, made before any tet is reordered.
fn marked_edge(topology: &Topology, tet: usize, f: usize, pair: usize) -> u32 {
    let order = MARKING_PERMUTATIONS[pair];
    let edges = MARKED.map(|e| {
        let [a, b] = EDGES[e];
        edge_between(order[a], order[b])
    });
    let in_face = |e: usize| EDGES[e].iter().all(|v| FACES[f].contains(v));
    let local = if in_face(edges[0]) { edges[0] } else { edges[1] };
    topology.tet_edges()[tet][local]
}

/// The pairs (as in [`MARKING_PERMUTATIONS`]) whose midpoints are closest.
fn shortest_pairs(corners: [[f64; 3]; 4]) -> Vec<usize> {
    let length = |pair: usize| {
        let [a, b, c, d] = MARKING_PERMUTATIONS[pair].map(|v| corners[v]);
        (0..3).map(|k| (a[k] + c[k] - b[k] - d[k]).powi(2)).sum::<f64>()
    };
    let lengths: [f64; 3] = std::array::from_fn(length);
    let shortest = lengths.iter().copied().fold(f64::INFINITY, f64::min);
    (0..3).filter(|&pair| lengths[pair] <= shortest * (1.0 + TIE)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{five_tet_cube, kuhn_cube};

    #[test]
    fn a_kuhn_cube_keeps_its_agreeing_marks() {
        let mut mesh = kuhn_cube(3).into_raw();
        let before = mesh.tets.clone();
        let topology = Topology::new(&mesh);
        mark_shortest(&mut mesh, &topology);
        assert_eq!(mesh.tets, before);
    }

    #[test]
    fn the_shortest_diagonal_is_found_whatever_the_order() {
        // A tet long in z: the closest opposite edges are the two long ones.
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, 0.0], [0.1, 0.0, 5.0], [0.0, 1.3, 5.5]];
        assert_eq!(shortest_pairs(corners).len(), 1);
        for order in MARKING_PERMUTATIONS {
            let moved = order.map(|v| corners[v]);
            let pair = shortest_pairs(moved)[0];
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
    fn the_regular_tets_tie_goes_to_the_order_at_hand() {
        let mesh = five_tet_cube();
        assert_eq!(shortest_pairs(mesh.corners(0)), [0, 1, 2]);
    }
}
