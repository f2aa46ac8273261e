//! The coarse simplices that edges and faces of a finer mesh lie in.

use rayon::prelude::*;

use crate::core::topology::{EdgeTets, Topology};
use crate::refinement::ancestry::{Ancestor, Ancestry};
use octruss_base::ragged::CHUNK;

impl Ancestry {
    /// For each fine edge the smallest coarse simplex that it lies in: a half of an
    /// edge in that edge, others in a face or else in a tet.
    ///
    /// # Panics
    /// If the topologies are not those of the two meshes.
    pub fn of_edges(&self, coarse: &Topology, fine: &Topology) -> Vec<Ancestor> {
        Ancestors::new(self, coarse).of_each(fine.edges())
    }

    /// For each fine face the smallest coarse simplex that it lies in: a face or
    /// else a tet.
    ///
    /// # Panics
    /// If the topologies are not those of the two meshes.
    pub fn of_faces(&self, coarse: &Topology, fine: &Topology) -> Vec<Ancestor> {
        Ancestors::new(self, coarse).of_each(fine.faces())
    }
}

/// The coarse mesh as its simplices are looked up.
struct Ancestors<'a> {
    ancestry: &'a Ancestry,
    coarse: &'a Topology,
    edge_tets: EdgeTets,
}

/// The ascending vertices of a coarse simplex.
#[derive(Default)]
struct Vertices {
    numbers: [u32; 4],
    count: usize,
}

impl<'a> Ancestors<'a> {
    fn new(ancestry: &'a Ancestry, coarse: &'a Topology) -> Self {
        assert_eq!(ancestry.vertices, coarse.vertex_count(), "the topology of the coarse mesh");
        Self { ancestry, coarse, edge_tets: EdgeTets::new(coarse) }
    }

    fn of_each<const N: usize>(&self, fine: &[[u32; N]]) -> Vec<Ancestor> {
        fine.par_iter().with_min_len(CHUNK).map(|vertices| self.of(vertices)).collect()
    }

    /// Fine vertices lie inside the coarse simplices that they are or halve, and so
    /// what they span lies inside the simplex of all vertices of these.
    fn of(&self, fine: &[u32]) -> Ancestor {
        let mut vertices = Vertices::default();
        for &vertex in fine {
            match self.ancestry.of_vertex(vertex) {
                Ancestor::Edge(edge) => {
                    self.coarse.edges()[edge as usize].into_iter().for_each(|v| vertices.add(v));
                }
                _ => vertices.add(vertex),
            }
        }
        self.spanned_by(&vertices).expect("a fine simplex lies in a coarse one")
    }

    /// The coarse simplex of these vertices.
    fn spanned_by(&self, vertices: &Vertices) -> Option<Ancestor> {
        match vertices.numbers[..vertices.count] {
            [a] => Some(Ancestor::Vertex(a)),
            [a, b] => self.coarse.edge_between(a, b).map(Ancestor::Edge),
            [a, b, c] => self.coarse.face_of([a, b, c]).map(Ancestor::Face),
            [a, b, c, d] => self.tet_between([a, b], [c, d]).map(Ancestor::Tet),
            _ => None,
        }
    }

    /// The tet that has these two edges opposite to each other.
    fn tet_between(&self, [a, b]: [u32; 2], [c, d]: [u32; 2]) -> Option<u32> {
        let (edge, opposite) = (self.coarse.edge_between(a, b)?, self.coarse.edge_between(c, d)?);
        let tets = self.edge_tets.of(edge as usize).iter().map(|slot| (slot / 6, slot % 6));
        let is_opposite = |&(tet, local): &(u32, u32)| {
            self.coarse.tet_edges()[tet as usize][5 - local as usize] == opposite
        };
        tets.clone().find(is_opposite).map(|(tet, _)| tet)
    }
}

impl Vertices {
    /// Adds a vertex, once.
    ///
    /// # Panics
    /// If there are more than four.
    fn add(&mut self, vertex: u32) {
        let place = self.numbers[..self.count].partition_point(|&other| other < vertex);
        if self.numbers[..self.count].get(place) == Some(&vertex) {
            return;
        }
        assert!(self.count < 4, "a fine simplex lies in a coarse one");
        self.numbers.copy_within(place..self.count, place + 1);
        self.numbers[place] = vertex;
        self.count += 1;
    }
}
