//! Which edges of a mesh are to be split.

use rayon::prelude::*;

use crate::core::topology::Topology;
use octruss_base::ragged::CHUNK;

/// Edges of a mesh that are to get a vertex at their midpoints.
///
/// Tets, faces and vertices are marked by their edges. Marks add up, whatever their
/// order.
///
/// ```
/// use octruss_mesh::{MarkedEdges, Topology, shapes};
/// let topology = Topology::new(shapes::five_tet_cube().raw());
/// let mut marks = MarkedEdges::new(&topology);
/// marks.mark_tets(&topology, [0]);
/// assert_eq!(marks.count(), 6);
/// // A vertex that only a corner tet of the cube has.
/// marks.mark_vertices(&topology, [1]);
/// assert_eq!(marks.count(), 6 + 3);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MarkedEdges {
    is_marked: Vec<bool>,
}

impl MarkedEdges {
    /// No edge of a mesh with this topology.
    pub fn new(topology: &Topology) -> Self {
        Self { is_marked: vec![false; topology.edges().len()] }
    }

    /// Every edge: each tet is split into eight.
    pub fn all(topology: &Topology) -> Self {
        Self { is_marked: vec![true; topology.edges().len()] }
    }

    /// Marks or leaves each edge as the list says, one entry an edge.
    pub(super) fn from_list(is_marked: Vec<bool>) -> Self {
        Self { is_marked }
    }

    /// Marks edges by the numbers of [`Topology::edges`].
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn mark_edges(&mut self, edges: impl IntoIterator<Item = u32>) {
        edges.into_iter().for_each(|edge| self.is_marked[edge as usize] = true);
    }

    /// Marks the three edges of faces, by the numbers of [`Topology::faces`].
    ///
    /// # Panics
    /// If there is no such face, or one of its edges is none of the marks' mesh.
    pub fn mark_faces(&mut self, topology: &Topology, faces: impl IntoIterator<Item = u32>) {
        faces.into_iter().for_each(|face| self.mark_edges(topology.face_edges()[face as usize]));
    }

    /// Marks the six edges of tets.
    ///
    /// # Panics
    /// If there is no such tet, or one of its edges is none of the marks' mesh.
    pub fn mark_tets(&mut self, topology: &Topology, tets: impl IntoIterator<Item = u32>) {
        tets.into_iter().for_each(|tet| self.mark_edges(topology.tet_edges()[tet as usize]));
    }

    /// Marks all edges that end in one of these vertices; goes once through the mesh.
    ///
    /// # Panics
    /// If there is no such vertex, or the topology has another number of edges.
    pub fn mark_vertices(&mut self, topology: &Topology, vertices: impl IntoIterator<Item = u32>) {
        let mut is_asked = vec![false; topology.vertex_count()];
        vertices.into_iter().for_each(|vertex| is_asked[vertex as usize] = true);
        assert_eq!(self.is_marked.len(), topology.edges().len(), "the topology of the mesh");
        let each = self.is_marked.par_iter_mut().zip(topology.edges()).with_min_len(CHUNK);
        each.for_each(|(mark, ends)| *mark |= ends.iter().any(|&end| is_asked[end as usize]));
    }

    /// Whether an edge is marked.
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn contains(&self, edge: u32) -> bool {
        self.is_marked[edge as usize]
    }

    /// For each edge whether it is marked.
    pub fn as_list(&self) -> &[bool] {
        &self.is_marked
    }

    /// The marked edges, ascending.
    pub fn edges(&self) -> impl Iterator<Item = u32> {
        (0u32..).zip(&self.is_marked).filter(|(_, mark)| **mark).map(|(edge, _)| edge)
    }

    /// How many edges are marked.
    pub fn count(&self) -> usize {
        self.is_marked.iter().filter(|mark| **mark).count()
    }
}
