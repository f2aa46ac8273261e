//! The faces at each edge, and the vertices across them.

use std::sync::OnceLock;

use super::edges_and_faces::Topology;
use octruss_base::groups::Groups;

/// The faces at each edge, by which of the edges ab, ac, bc of the face
/// a < b < c it is.
///
/// Round an edge pq the third vertices below p belong to the faces whose last
/// edge it is, those between p and q to the faces whose middle edge, and those
/// above q to the faces whose first edge. Round an edge inside a solid they are
/// the link, each vertex once.
///
/// The lists are made when they are first asked for.
#[derive(Debug, Clone)]
pub struct EdgeFaces<'a> {
    topology: &'a Topology,
    middle: OnceLock<Groups<u32>>,
    last: OnceLock<Groups<u32>>,
}

impl<'a> EdgeFaces<'a> {
    /// Of a mesh with this topology.
    pub fn new(topology: &'a Topology) -> Self {
        Self { topology, middle: OnceLock::new(), last: OnceLock::new() }
    }

    /// The faces that an edge is the middle edge of, ascending.
    #[inline]
    pub fn middle(&self, edge: u32) -> &[u32] {
        self.middle.get_or_init(|| by_edge(self.topology, 1)).of(edge as usize)
    }

    /// How many faces before this one an edge is the middle edge of.
    #[inline]
    pub fn rank_in_middle(&self, edge: u32, face: u32) -> u32 {
        self.middle(edge).iter().take_while(|&&other| other < face).count() as u32
    }

    /// The faces that an edge is the last edge of, ascending.
    #[inline]
    pub fn last(&self, edge: u32) -> &[u32] {
        self.last.get_or_init(|| by_edge(self.topology, 2)).of(edge as usize)
    }

    /// How many faces an edge has.
    #[inline]
    pub fn count(&self, edge: u32) -> usize {
        self.last(edge).len() + self.middle(edge).len() + self.topology.faces_from(edge).len()
    }

    /// The third vertices below the lower end of an edge, ascending.
    pub fn below(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.last(edge).iter().map(|&f| self.topology.faces[f as usize][0])
    }

    /// The third vertices between the ends of an edge, ascending.
    pub fn between(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.middle(edge).iter().map(|&f| self.topology.faces[f as usize][1])
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
fn by_edge(topology: &Topology, place: usize) -> Groups<u32> {
    let face_edges = &topology.face_edges;
    Groups::new(topology.edges.len(), face_edges.len(), |f| [(face_edges[f][place], f as u32)])
}
