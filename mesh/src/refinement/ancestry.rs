//! Who descends from whom in a refinement.

use crate::refinement::lineage::Lineage;

/// The smallest simplex of a coarse mesh that a simplex of a finer one lies in,
/// by its number there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ancestor {
    /// A vertex.
    Vertex(u32),
    /// An edge, by the numbers of [`crate::Topology::edges`].
    Edge(u32),
    /// A face, by the numbers of [`crate::Topology::faces`].
    Face(u32),
    /// A tet.
    Tet(u32),
}

/// Which coarse edges have a fine vertex at their midpoint.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SplitEdges {
    /// All of so many.
    All(usize),
    /// These, ascending.
    Some(Vec<u32>),
}

/// Where each part of a fine mesh lies in the coarse one.
///
/// Fine vertices are the coarse ones, in order, then one for each edge that was
/// split, in edge order. Parts of tets and of tagged triangles and edges follow
/// one another in the order of their wholes. A tet may have any number of parts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ancestry {
    /// The number of coarse vertices.
    pub vertices: usize,
    /// The edges that were split.
    pub split_edges: SplitEdges,
    /// From coarse tets to fine tets.
    pub tets: Lineage,
    /// From coarse tagged triangles to fine tagged triangles.
    pub triangles: Lineage,
    /// From coarse tagged edges to fine tagged edges.
    pub edges: Lineage,
}

impl Ancestry {
    /// Whether every coarse edge was split.
    pub fn is_uniform(&self) -> bool {
        matches!(self.split_edges, SplitEdges::All(_))
    }

    /// How many vertices the fine mesh has.
    pub fn fine_vertices(&self) -> usize {
        let split = match &self.split_edges {
            SplitEdges::All(count) => *count,
            SplitEdges::Some(edges) => edges.len(),
        };
        self.vertices + split
    }

    /// The coarse vertex that a fine vertex is, or the coarse edge that it is the
    /// midpoint of.
    ///
    /// # Panics
    /// If there is no such fine vertex.
    pub fn of_vertex(&self, fine: u32) -> Ancestor {
        assert!((fine as usize) < self.fine_vertices(), "no fine vertex {fine}");
        match ((fine as usize).checked_sub(self.vertices), &self.split_edges) {
            (None, _) => Ancestor::Vertex(fine),
            (Some(edge), SplitEdges::All(_)) => Ancestor::Edge(edge as u32),
            (Some(place), SplitEdges::Some(edges)) => Ancestor::Edge(edges[place]),
        }
    }

    /// The fine vertex at the midpoint of a coarse edge; none if it was not split.
    pub fn midpoint(&self, edge: u32) -> Option<u32> {
        let place = match &self.split_edges {
            SplitEdges::All(count) => Some(edge as usize).filter(|edge| edge < count),
            SplitEdges::Some(edges) => edges.binary_search(&edge).ok(),
        };
        place.map(|place| (self.vertices + place) as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_and_midpoints_are_each_others_inverse() {
        let some = SplitEdges::Some(vec![1, 4, 5]);
        for (split_edges, fine) in [(SplitEdges::All(7), 11), (some, 7)] {
            let none = || Lineage::uniform(0, 1);
            let ancestry = Ancestry {
                vertices: 4,
                split_edges,
                tets: none(),
                triangles: none(),
                edges: none(),
            };
            assert_eq!(ancestry.fine_vertices(), fine);
            let mut split = 0;
            for edge in 0..9 {
                if let Some(vertex) = ancestry.midpoint(edge) {
                    assert_eq!(ancestry.of_vertex(vertex), Ancestor::Edge(edge));
                    split += 1;
                }
            }
            assert_eq!(split + 4, fine);
            assert!((0..4).all(|v| ancestry.of_vertex(v) == Ancestor::Vertex(v)));
        }
    }
}
