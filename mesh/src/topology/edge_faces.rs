//! The faces at each edge, and the vertices across them.

use super::Topology;
use crate::groups::Groups;

/// The faces at each edge, by which of the edges ab, ac, bc of the face
/// a < b < c it is.
///
/// Round an edge pq the third vertices below p belong to the faces whose last
/// edge it is, those between p and q to the faces whose middle edge, and those
/// above q to the faces whose first edge. Round an edge inside a solid they are
/// the link, each vertex once.
#[derive(Debug, Clone)]
pub struct EdgeFaces<'a> {
    topology: &'a Topology,
    middle: Groups<u32>,
    last: Groups<u32>,
}

impl<'a> EdgeFaces<'a> {
    /// Lists the faces at every edge.
    pub fn new(topology: &'a Topology) -> Self {
        Self { topology, middle: by_edge(topology, 1), last: by_edge(topology, 2) }
    }

    /// How many faces an edge has.
    pub fn count(&self, edge: u32) -> usize {
        let [last, middle] = [&self.last, &self.middle].map(|faces| faces.of(edge as usize).len());
        last + middle + self.topology.faces_from(edge).len()
    }

    /// The third vertices below the lower end of an edge, ascending.
    pub fn below(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.last.of(edge as usize).iter().map(|&f| self.topology.faces[f as usize][0])
    }

    /// The third vertices between the ends of an edge, ascending.
    pub fn between(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.middle.of(edge as usize).iter().map(|&f| self.topology.faces[f as usize][1])
    }

    /// The third vertices above the higher end of an edge, ascending.
    pub fn above(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.topology.faces_from(edge).map(|f| self.topology.faces[f as usize][2])
    }

    /// All third vertices at an edge, ascending.
    pub fn thirds(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.below(edge).chain(self.between(edge)).chain(self.above(edge))
    }
}

/// The faces whose edge ab, ac or bc (0, 1, 2) each edge is, ascending.
pub(crate) fn by_edge(topology: &Topology, place: usize) -> Groups<u32> {
    let face_edges = &topology.face_edges;
    Groups::new(topology.edges.len(), face_edges.len(), |f| [(face_edges[f][place], f as u32)])
}
