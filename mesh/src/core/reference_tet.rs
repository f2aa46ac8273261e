//! The reference tetrahedron: its numbering, its marked pair and its red split.
//!
//! ```text
//!            x3                  edges        faces (opposite xi, outward)
//!           /|\                  0: x0 x1     0: x1 x2 x3
//!          / | \                 1: x0 x2     1: x0 x3 x2
//!         /  |  \                2: x0 x3     2: x0 x1 x3
//!       x0 --|-- x2              3: x1 x2     3: x0 x2 x1
//!         \  |  /                4: x1 x3
//!          \ | /                 5: x2 x3
//!           \|/
//!            x1                  marked pair: {x0 x2, x1 x3} = edges 1 and 4
//! ```
//!
//! The red split joins the midpoints of the marked pair (the inner diagonal
//! x02 – x13) and makes eight children, whose order of vertices hands the
//! marking on. The nodes 0 to 3 are the corners, 4 + e the midpoint of edge e.
//! All tables of the crate about a single tet are here; nothing else may
//! reorder a tet's vertices.

/// The ends of each edge, by local vertex number.
pub const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

/// The vertices of the face opposite each vertex, oriented outward in a
/// positively oriented tet.
pub const FACES: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// The two marked edges of a tet, x0 x2 and x1 x3.
pub const MARKED: [usize; 2] = [1, 4];

/// The three pairs of opposite edges, by the entry of [`MARKING_PERMUTATIONS`]
/// that marks them.
pub const PAIRS: [[usize; 2]; 3] = [MARKED, [0, 5], [2, 3]];

/// The eight children of the red split by node, all oriented as the parent:
/// four at the corners, then the four quarters of the inner octahedron.
pub const CHILDREN: [[usize; 4]; 8] = [
    [0, 4, 5, 6],
    [4, 1, 7, 8],
    [5, 7, 2, 9],
    [6, 8, 9, 3],
    [4, 5, 6, 8],
    [7, 5, 4, 8],
    [5, 6, 8, 9],
    [8, 7, 5, 9],
];

/// The even permutations that put each pair of opposite edges in the marked
/// place: entry p marks {x0x2, x1x3}, {x0x1, x2x3}, {x0x3, x1x2} for p = 0, 1, 2.
pub const MARKING_PERMUTATIONS: [[usize; 4]; 3] = [[0, 1, 2, 3], [0, 3, 1, 2], [0, 2, 3, 1]];

/// What a tet is in the octet truss that the red split makes of each initial
/// tet: a tetrahedral cell, or a quarter of an octahedron.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CellState {
    /// A tetrahedral cell, as every initial tet.
    #[default]
    Tetrahedron,
    /// A quarter of an octahedron whose diagonal is the edge x0 x2.
    QuarterRoundX0X2,
    /// A quarter of an octahedron whose diagonal is the edge x1 x3.
    QuarterRoundX1X3,
}

impl CellState {
    /// The local edge that is the diagonal of the octahedron, if it is part of one.
    pub const fn diagonal(self) -> Option<usize> {
        match self {
            Self::Tetrahedron => None,
            Self::QuarterRoundX0X2 => Some(1),
            Self::QuarterRoundX1X3 => Some(4),
        }
    }

    /// The states of the eight [`CHILDREN`].
    pub const fn children(self) -> [Self; CHILDREN.len()] {
        const T: CellState = CellState::Tetrahedron;
        const P: CellState = CellState::QuarterRoundX0X2;
        const Q: CellState = CellState::QuarterRoundX1X3;
        match self {
            T => [T, T, T, T, Q, Q, P, P],
            P => [P, P, P, P, T, P, Q, T],
            Q => [Q, Q, Q, Q, P, T, T, Q],
        }
    }
}

/// The edge between two local vertices.
pub const fn edge_between(a: usize, b: usize) -> usize {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    match (low, high) {
        (0, 1) => 0,
        (0, 2) => 1,
        (0, 3) => 2,
        (1, 2) => 3,
        (1, 3) => 4,
        _ => 5,
    }
}

/// The two local vertices that are not on an edge: the ends of the opposite edge.
pub const fn opposite_ends(edge: usize) -> [usize; 2] {
    EDGES[5 - edge]
}

/// The one edge of a pair that lies in a face; each pair has another.
pub const fn edge_in_face(pair: usize, face: usize) -> usize {
    let [first, second] = PAIRS[pair];
    // An edge lies in the face opposite a vertex that is none of its ends.
    let [a, b] = EDGES[first];
    if a == face || b == face { second } else { first }
}

/// The positions of a tet's four vertices.
#[inline]
pub fn corners(points: &[[f64; 3]], [a, b, c, d]: [u32; 4]) -> [[f64; 3]; 4] {
    [points[a as usize], points[b as usize], points[c as usize], points[d as usize]]
}

/// Six times the signed volume of a tet, in cubed mesh units.
#[inline]
pub fn six_volumes(corners: [[f64; 3]; 4]) -> f64 {
    let [o, a, b, c] = corners;
    // No map: it is not inlined, and this is called for every tet of every level.
    let from_o = |p: [f64; 3]| [p[0] - o[0], p[1] - o[1], p[2] - o[2]];
    let (a, b, c) = (from_o(a), from_o(b), from_o(c));
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f64; 3]; 4] =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    fn node(n: usize) -> [f64; 3] {
        if n < 4 {
            return CORNERS[n];
        }
        let [a, b] = EDGES[n - 4];
        std::array::from_fn(|k| 0.5 * (CORNERS[a][k] + CORNERS[b][k]))
    }

    #[test]
    fn children_have_an_eighth_of_the_volume_and_the_parents_orientation() {
        for child in CHILDREN {
            assert_eq!(six_volumes(child.map(node)), 0.125);
        }
    }

    #[test]
    fn opposite_edges_share_no_vertex() {
        for edge in 0..6 {
            let mut all = [EDGES[edge], opposite_ends(edge)].concat();
            all.sort_unstable();
            assert_eq!(all, [0, 1, 2, 3]);
        }
    }

    #[test]
    fn marking_permutations_are_even_and_mark_each_pair() {
        for (p, pair) in [[[0, 2], [1, 3]], [[0, 1], [2, 3]], [[0, 3], [1, 2]]].iter().enumerate() {
            assert_eq!(PAIRS[p].map(|e| EDGES[e]), *pair);
            let order = MARKING_PERMUTATIONS[p];
            assert_eq!(six_volumes(order.map(|v| CORNERS[v])), 1.0, "even");
            let marked = MARKED.map(|e| {
                let mut ends = EDGES[e].map(|v| order[v]);
                ends.sort_unstable();
                ends
            });
            assert!(marked.contains(&pair[0]) && marked.contains(&pair[1]));
        }
    }

    #[test]
    fn each_pair_has_its_own_edge_in_a_face() {
        for face in 0..4 {
            let mut edges = [0, 1, 2].map(|pair| edge_in_face(pair, face));
            assert!(edges.iter().all(|&e| EDGES[e].iter().all(|v| FACES[face].contains(v))));
            edges.sort_unstable();
            assert!(edges[0] < edges[1] && edges[1] < edges[2]);
        }
    }

    #[test]
    fn faces_point_outward() {
        for (opposite, [a, b, c]) in FACES.iter().enumerate() {
            // The face seen from outside with the opposite vertex behind it.
            let corners = [*a, *b, *c, opposite].map(|v| CORNERS[v]);
            assert!(six_volumes(corners) < 0.0);
        }
    }
}
