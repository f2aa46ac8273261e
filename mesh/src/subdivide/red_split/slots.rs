//! Where each edge and face of a child comes from: tables made from
//! [`CHILDREN`] at compile time.

use super::parts::PARTS;
use crate::core::reference_tet::{CHILDREN, EDGES, FACES, edge_between};

/// The 25 edges of a split tet: 2 · edge + end (0 or 1 of its ends) for halves,
/// [`CUTS`] + 3 · face + corner (0, 1, 2 of its vertices) for cuts, then the
/// diagonal.
pub const EDGE_SLOTS: usize = 25;
pub const CUTS: usize = 12;
pub const DIAGONAL: usize = 24;

/// The 24 faces of a split tet: 4 · face + corner for corner faces and 4 · face +
/// 3 for middle faces, then the inner faces: [`INNER`] + vertex for the one that
/// cuts off a vertex, [`INNER`] + [`beside_diagonal`] for the four at the diagonal.
pub const FACE_SLOTS: usize = 24;
pub const INNER: usize = 16;
pub const INNER_FACES: usize = FACE_SLOTS - INNER;

/// The nodes of each child, [`CHILDREN`] in bytes.
pub const CHILD_NODES: [[u8; 4]; PARTS] = child_nodes();

/// The slots of each child's edges, in the order of [`EDGES`].
pub const CHILD_EDGES: [[u8; 6]; PARTS] = child_edges();

/// The slots of each child's faces, face i opposite its vertex i.
pub const CHILD_FACES: [[u8; 4]; PARTS] = child_faces();

/// The two children on each inner face, the smaller number first.
pub const INNER_CHILDREN: [[u32; 2]; INNER_FACES] = inner_children();

/// The child whose face the middle of each coarse face is.
pub const MIDDLE_CHILD: [u32; 4] = middle_child();

/// Two different edges of a tet, seen from the inner edge between their midpoints.
#[derive(Clone, Copy)]
pub struct Between {
    /// The slot of that inner edge.
    pub slot: u8,
    /// The third edge at the corner that a cut cuts off; any of a diagonal.
    pub third: u8,
    /// That corner.
    pub corner: u8,
}

/// For each two edges of a tet the inner edge between them.
pub const BETWEEN: [[Between; 6]; 6] = between();

/// The inner face at the diagonal that ends in the midpoint of an unmarked edge.
pub const fn beside_diagonal(edge: usize) -> usize {
    [4, 4, 5, 6, 4, 7][edge]
}

/// The vertex that two edges share, if they do.
const fn common(p: usize, q: usize) -> Option<usize> {
    let ([a, b], [c, d]) = (EDGES[p], EDGES[q]);
    if a == c || a == d {
        Some(a)
    } else if b == c || b == d {
        Some(b)
    } else {
        None
    }
}

const fn other_end(edge: usize, end: usize) -> usize {
    let [a, b] = EDGES[edge];
    if a == end { b } else { a }
}

const fn corner_of(face: usize, vertex: usize) -> usize {
    let mut corner = 0;
    while FACES[face][corner] != vertex {
        corner += 1;
    }
    corner
}

const fn inner_edge_slot(p: usize, q: usize) -> usize {
    match common(p, q) {
        None => DIAGONAL,
        Some(corner) => {
            let face = 6 - corner - other_end(p, corner) - other_end(q, corner);
            CUTS + 3 * face + corner_of(face, corner)
        }
    }
}

/// The slot of the edge between two nodes.
const fn edge_slot(nodes: [usize; 2]) -> usize {
    let [low, high] = if nodes[0] < nodes[1] { nodes } else { [nodes[1], nodes[0]] };
    if low < 4 {
        2 * (high - 4) + (EDGES[high - 4][1] == low) as usize
    } else {
        inner_edge_slot(low - 4, high - 4)
    }
}

/// The slot of the face of three nodes.
const fn face_slot(nodes: [usize; 3]) -> usize {
    let mut i = 0;
    while i < 3 {
        if nodes[i] < 4 {
            let corner = nodes[i];
            let [p, q] = [nodes[(i + 1) % 3] - 4, nodes[(i + 2) % 3] - 4];
            let face = 6 - corner - other_end(p, corner) - other_end(q, corner);
            return 4 * face + corner_of(face, corner);
        }
        i += 1;
    }
    inner_or_middle([nodes[0] - 4, nodes[1] - 4, nodes[2] - 4])
}

const fn inner_or_middle([p, q, r]: [usize; 3]) -> usize {
    // Of three edges of which two are opposite, the third has the face beside
    // the diagonal.
    match (common(p, q), common(p, r), common(q, r)) {
        (None, _, _) => INNER + beside_diagonal(r),
        (_, None, _) => INNER + beside_diagonal(q),
        (_, _, None) => INNER + beside_diagonal(p),
        (Some(a), Some(b), Some(c)) if a == b && b == c => INNER + a,
        (Some(a), Some(b), Some(c)) => 4 * (6 - a - b - c) + 3,
    }
}

const fn child_nodes() -> [[u8; 4]; PARTS] {
    let mut nodes = [[0; 4]; PARTS];
    let mut child = 0;
    while child < PARTS {
        let mut place = 0;
        while place < 4 {
            nodes[child][place] = CHILDREN[child][place] as u8;
            place += 1;
        }
        child += 1;
    }
    nodes
}

const fn child_edges() -> [[u8; 6]; PARTS] {
    let mut slots = [[0; 6]; PARTS];
    let mut child = 0;
    while child < PARTS {
        let mut edge = 0;
        while edge < 6 {
            let [a, b] = EDGES[edge];
            slots[child][edge] = edge_slot([CHILDREN[child][a], CHILDREN[child][b]]) as u8;
            edge += 1;
        }
        child += 1;
    }
    slots
}

const fn child_faces() -> [[u8; 4]; PARTS] {
    let mut slots = [[0; 4]; PARTS];
    let mut child = 0;
    while child < PARTS {
        let (nodes, mut face) = (CHILDREN[child], 0);
        while face < 4 {
            let [a, b, c] = FACES[face];
            slots[child][face] = face_slot([nodes[a], nodes[b], nodes[c]]) as u8;
            face += 1;
        }
        child += 1;
    }
    slots
}

const fn inner_children() -> [[u32; 2]; INNER_FACES] {
    let mut children = [[PARTS as u32; 2]; INNER_FACES];
    let mut child = 0;
    while child < PARTS {
        let mut face = 0;
        while face < 4 {
            let slot = CHILD_FACES[child][face] as usize;
            if slot >= INNER {
                let place = (children[slot - INNER][0] != PARTS as u32) as usize;
                children[slot - INNER][place] = child as u32;
            }
            face += 1;
        }
        child += 1;
    }
    children
}

const fn middle_child() -> [u32; 4] {
    let mut children = [0; 4];
    let mut child = 4;
    while child < PARTS {
        let mut face = 0;
        while face < 4 {
            let slot = CHILD_FACES[child][face] as usize;
            if slot < INNER {
                children[slot / 4] = child as u32;
            }
            face += 1;
        }
        child += 1;
    }
    children
}

const fn between() -> [[Between; 6]; 6] {
    let mut table = [[Between { slot: DIAGONAL as u8, third: 0, corner: 0 }; 6]; 6];
    let mut p = 0;
    while p < 6 {
        let mut q = 0;
        while q < 6 {
            if p != q
                && let Some(corner) = common(p, q)
            {
                let third = 6 - corner - other_end(p, corner) - other_end(q, corner);
                table[p][q] = Between {
                    slot: inner_edge_slot(p, q) as u8,
                    third: edge_between(corner, third) as u8,
                    corner: corner as u8,
                };
            }
            q += 1;
        }
        p += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_inner_face_has_two_children_and_every_other_one() {
        let mut uses = [0; FACE_SLOTS];
        CHILD_FACES.as_flattened().iter().for_each(|&slot| uses[usize::from(slot)] += 1);
        assert!(uses[..INNER].iter().all(|&count| count == 1));
        assert!(uses[INNER..].iter().all(|&count| count == 2));
        assert!(INNER_CHILDREN.iter().all(|[low, high]| low < high && *high < PARTS as u32));
    }

    #[test]
    fn the_diagonal_has_four_children_and_each_edge_of_the_octahedron_three() {
        let mut uses = [0; EDGE_SLOTS];
        CHILD_EDGES.as_flattened().iter().for_each(|&slot| uses[usize::from(slot)] += 1);
        assert_eq!(uses[DIAGONAL], 4);
        // A half is at one corner child; a cut at that and one or two quarters.
        assert!(uses[..CUTS].iter().all(|&count| count == 1));
        assert!(uses[CUTS..DIAGONAL].iter().all(|&count| (2..=3).contains(&count)));
    }
}
