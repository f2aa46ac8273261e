//! Exact positions in a refined star.

use crate::core::topology::Topology;

/// Where a vertex of a refined star lies: its barycentric coordinates with
/// respect to the star's vertices other than the centre, times 2^level; pairs
/// (vertex, coordinate) ascending, without zeros.
///
/// The vertex in the same place one level finer, at half the distance from the
/// centre, has the same numbers: levels are compared without rounding.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place(Vec<(u32, u32)>);

impl Place {
    /// A vertex of the unrefined star, whose centre is 0.
    fn of_vertex(vertex: u32) -> Self {
        Self(if vertex == 0 { Vec::new() } else { vec![(vertex, 1)] })
    }

    /// How many layers of vertices lie between this one and the centre, itself
    /// included.
    pub fn layer(&self) -> u32 {
        self.0.iter().map(|entry| entry.1).sum()
    }

    /// The place one level finer of the point halfway to another place.
    fn plus(&self, other: &Self) -> Self {
        let mut sum: Vec<(u32, u32)> = self.0.iter().chain(&other.0).copied().collect();
        sum.sort_unstable();
        let merged = sum.chunk_by(|a, b| a.0 == b.0);
        Self(merged.map(|same| (same[0].0, same.iter().map(|entry| entry.1).sum())).collect())
    }
}

/// The places of a star's own vertices.
pub(crate) fn initial(vertices: usize) -> Vec<Place> {
    (0..vertices as u32).map(Place::of_vertex).collect()
}

/// The places of the red split's vertices, in their order.
pub(crate) fn refined(places: &[Place], topology: &Topology) -> Vec<Place> {
    let old = places.iter().map(|place| place.plus(place));
    let midpoints =
        topology.edges().iter().map(|&[a, b]| places[a as usize].plus(&places[b as usize]));
    old.chain(midpoints).collect()
}
