//! The limit of each boundary vertex as a row: the left eigenvector of the eigenvalue 1
//! of its stratum's rules. Every approximating scheme has the same.
//!
//! Rows of curves and smooth surfaces have the form (own, 1, …, 1) / (own + n) with n
//! neighbours of the stratum: own is 4 on a curve (5 or 6 beside one or two parabola
//! ends), n on a surface (2 for n = 3). Scaled by own + n, the rows of curves among
//! themselves, and those of a surface, are symmetric.

use smallvec::SmallVec;

use super::curve::parabola_ends;
use super::surface::{limit_own_weight, warren_weight};
use crate::core::curve_ends::CurveEnds;
use crate::core::strata::Strata;
use crate::core::topology::Topology;
use crate::refinement::subdivision_matrix::Row;

/// The limit rules of approximating schemes on one mesh.
#[derive(Clone, Copy)]
pub(crate) struct LimitRules<'a> {
    pub strata: &'a Strata,
    pub topology: &'a Topology,
    pub curve_ends: CurveEnds,
}

impl LimitRules<'_> {
    /// Adds the entries of a vertex. Fixed vertices and those of the solid stay.
    pub fn row(&self, vertex: u32, row: &mut Row) {
        match self.own_weight(vertex) {
            None => row.add(vertex, 1.0),
            Some(_) if self.is_dart(vertex) => self.dart_row(vertex, row),
            Some(own) => {
                let neighbours = self.neighbours(vertex);
                let total = own + neighbours.len() as f64;
                row.add(vertex, own / total);
                neighbours.iter().for_each(|&neighbour| row.add(neighbour, total.recip()));
            }
        }
    }

    /// The neighbours within the stratum of a curve or surface vertex, ascending.
    pub fn neighbours(&self, vertex: u32) -> &[u32] {
        match self.strata.vertex_dimensions[vertex as usize] {
            1 => self.strata.curve_neighbours(vertex),
            _ => self.strata.surface_neighbours(vertex),
        }
    }

    /// The weight of a curve or surface vertex against 1 for each neighbour; at the end
    /// of a crease that of a smooth vertex. `None` if the vertex is its own limit.
    pub fn own_weight(&self, vertex: u32) -> Option<f64> {
        match self.strata.vertex_dimensions[vertex as usize] {
            1 => Some((4 + parabola_ends(self.strata, vertex, self.curve_ends)) as f64),
            2 => match self.strata.surface_neighbours(vertex).len() {
                0..3 => None,
                n => Some(limit_own_weight(n)),
            },
            _ => None,
        }
    }

    /// Whether exactly one crease ends in a vertex of a surface.
    pub fn is_dart(&self, vertex: u32) -> bool {
        self.strata.vertex_dimensions[vertex as usize] == 2
            && self.strata.curve_neighbours(vertex).len() == 1
    }

    /// At a dart the vertex rule is smooth, but the edge rule on the crease is the
    /// midpoint. With β the smooth rule's weight of a neighbour and weight 1 for the
    /// vertex, those of the neighbours l solve 5/8 l_j − 1/8 (l_j−1 + l_j+1) = β off the
    /// crease, where l_0 of the crease counts as 0, and ½ l_0 = β + 1/8 (l_1 + l_n−1).
    fn dart_row(&self, vertex: u32, row: &mut Row) {
        let ring = self.strata.surface_neighbours(vertex);
        let beta = warren_weight(ring.len());
        let crease = self.strata.curve_neighbours(vertex)[0];
        let beside: SmallVec<[_; 12]> = ring.iter().map(|&v| self.places(vertex, v)).collect();
        let mut weights: SmallVec<[f64; 12]> = ring.iter().map(|_| 0.0).collect();
        let sum = |weights: &[f64], at: usize| {
            beside[at].iter().map(|&other| weights[other]).sum::<f64>()
        };
        // The weights of two neighbours count 1/5 each: an iteration leaves at most 2/5 of
        // the error.
        for _ in 0..45 {
            let off_crease = (0..ring.len()).filter(|&at| ring[at] != crease);
            off_crease.for_each(|at| weights[at] = (8.0 * beta + sum(&weights, at)) / 5.0);
        }
        if let Ok(at) = ring.binary_search(&crease) {
            weights[at] = 2.0 * beta + 0.25 * sum(&weights, at);
        }
        let total = 1.0 + weights.iter().sum::<f64>();
        row.add(vertex, total.recip());
        ring.iter().zip(weights).for_each(|(&v, weight)| row.add(v, weight / total));
    }

    /// Where in the ring round a surface vertex the neighbours of one of them are.
    fn places(&self, centre: u32, neighbour: u32) -> SmallVec<[usize; 2]> {
        let ring = self.strata.surface_neighbours(centre);
        let edge = self.topology.edge_between(centre, neighbour);
        let thirds = edge.map_or(&[][..], |edge| self.strata.opposite_vertices(edge));
        thirds.iter().filter_map(|third| ring.binary_search(third).ok()).collect()
    }
}
