//! How a tet is split, by which of its edges are.

use crate::core::reference_tet::{FACES, edge_between};

/// How a tet is split.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pattern {
    /// It stays.
    Whole,
    /// One edge, two, or three that are not all in one face: bisections, 1-to-2 each.
    Bisections,
    /// The three edges of the face opposite this local vertex: 1-to-4.
    Quarters(usize),
    /// All six edges: 1-to-8.
    Red,
}

impl Pattern {
    /// By the bits of the local edges that are split.
    ///
    /// # Panics
    /// If there are four or five, which closed marks never have.
    pub fn of(edges: u8) -> Self {
        match edges.count_ones() {
            0 => Self::Whole,
            6 => Self::Red,
            3 => FACE_EDGES
                .iter()
                .position(|&face| face == edges)
                .map_or(Self::Bisections, Self::Quarters),
            1 | 2 => Self::Bisections,
            _ => panic!("closed marks leave no tet with edges {:06b} split", edges),
        }
    }
}

/// The bits of the edges of the face opposite each vertex.
const FACE_EDGES: [u8; 4] = face_edges();

const fn face_edges() -> [u8; 4] {
    let mut bits = [0; 4];
    let mut face = 0;
    while face < 4 {
        let [a, b, c] = FACES[face];
        bits[face] = 1 << edge_between(a, b) | 1 << edge_between(b, c) | 1 << edge_between(c, a);
        face += 1;
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_64_sets_of_edges_43_are_closed_and_have_their_patterns() {
        let closed = (0..64u8).filter(|edges| !matches!(edges.count_ones(), 4 | 5));
        let patterns: Vec<Pattern> = closed.map(Pattern::of).collect();
        let count = |wanted: fn(&Pattern) -> bool| patterns.iter().filter(|p| wanted(p)).count();
        assert_eq!(patterns.len(), 43);
        assert_eq!(count(|p| *p == Pattern::Whole), 1);
        // 6 of one edge, 15 of two, 20 of three but for the 4 faces.
        assert_eq!(count(|p| *p == Pattern::Bisections), 6 + 15 + 16);
        assert_eq!(count(|p| matches!(p, Pattern::Quarters(_))), 4);
        assert_eq!(count(|p| *p == Pattern::Red), 1);
    }
}
