//! The edges at each vertex.

use rayon::prelude::*;

use super::edges_and_faces::Topology;
use octruss_base::large_array::zeroed;
use octruss_base::ragged::{self, CHUNK};

/// The edges at each vertex, ascending.
///
/// The place of edge e in the list of vertex v, counted over all lists, is also
/// the number of the half edge (v, midpoint of e) in the red-refined mesh.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VertexEdges {
    offsets: Vec<u32>,
    edges: Vec<u32>,
}

impl VertexEdges {
    /// Lists the edges at every vertex.
    pub fn new(topology: &Topology) -> Self {
        let (edges, from) = (&topology.edges, &topology.first_edges);
        let ending = topology.edges_to();
        let offsets: Vec<u32> = from.iter().zip(ending.offsets()).map(|(a, b)| a + b).collect();
        let mut lists = zeroed(2 * edges.len());
        ragged::for_each(&offsets, &mut lists[..], |first, last, lists| {
            let edges = (first..last)
                .flat_map(|v| ending.of(v).iter().copied().chain(from[v]..from[v + 1]));
            lists.iter_mut().zip(edges).for_each(|(place, edge)| *place = edge);
        });
        Self { offsets, edges: lists }
    }

    /// The edges at one vertex, ascending.
    pub fn of(&self, vertex: usize) -> &[u32] {
        &self.edges[self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize]
    }

    /// Where the list of each vertex starts; one more offset than vertices.
    pub(crate) fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// For each edge, its places in the lists of its lower and its higher end.
    pub fn places(&self, topology: &Topology) -> Vec<[u32; 2]> {
        let place = |edge: usize| {
            let [low, high] = topology.edges[edge].map(|v| v as usize);
            let from_end = topology.first_edges[low + 1] - edge as u32;
            let ending = self.of(high).iter();
            let rank = ending.take_while(|&&other| other < edge as u32).count() as u32;
            [self.offsets[low + 1] - from_end, self.offsets[high] + rank]
        };
        let mut places = zeroed(topology.edges.len());
        let numbered = places.par_iter_mut().with_min_len(CHUNK).enumerate();
        numbered.for_each(|(edge, places)| *places = place(edge));
        places
    }
}
