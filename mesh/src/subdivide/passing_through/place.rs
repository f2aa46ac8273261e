//! Where new vertices go, given the limits of the boundary's.

use rayon::prelude::*;

use super::spread::spread;
use crate::core::edge_length::mean_edge_length;
use crate::core::mirrors::Unfolded;
use crate::core::strata::Strata;
use crate::core::topology::Topology;
use octruss_base::large_array::filled;
use octruss_base::ragged::CHUNK;
use octruss_base::vector3::{Vector3, add, cross, dot3, length, scale, subtract};

/// In mean edge lengths, what solving for control points leaves, ten times over.
const ROUNDING: f64 = 1e-9;

/// The positions of a fine mesh with new boundary vertices moved from the midpoints of
/// their edges towards their limits, along the normal of the coarse facets, and on a
/// crease at right angles to the edge. The coarse vertices stay.
///
/// `limits` belong to `listed`, the fine vertices of curves and surfaces. With `all_the_way`
/// vertices go to their limits themselves.
pub(super) fn along_normals(
    (coarse, strata): (&Unfolded, &Strata),
    fine: &Unfolded,
    listed: &[u32],
    limits: &[Vector3],
    all_the_way: bool,
) -> Vec<Vector3> {
    let rounding = ROUNDING * mean_edge_length(&coarse.mesh.points, &coarse.topology);
    let (points, topology) = (&*coarse.mesh.points, &*coarse.topology);
    let facets = Facets { points, topology, strata, all_the_way, rounding };
    let n = coarse.vertices();
    let first_new = listed.partition_point(|&v| (v as usize) < n);
    let new = listed[first_new..].par_iter().with_min_len(CHUNK).zip(&limits[first_new..]);
    let edge_of = |v: u32| coarse.edge(v as usize - n);
    let moved: Vec<Vector3> =
        new.map(|(&v, &limit)| facets.displacement(edge_of(v), limit)).collect();
    let mut displacements = filled([0.0; 3], fine.topology.vertex_count());
    let mut is_inner = vec![true; coarse.edges()];
    for (&vertex, moved) in listed[first_new..].iter().zip(moved) {
        displacements[vertex as usize] = moved;
        is_inner[vertex as usize - n] = false;
    }
    let edges = (n as u32..).zip(is_inner);
    let inner: Vec<u32> = edges.filter(|&(_, is_inner)| is_inner).map(|(v, _)| v).collect();
    spread(fine, &inner, &mut displacements);
    let midpoint =
        |edge: usize| facets.midpoint(coarse.topology.edges()[coarse.edge(edge) as usize]);
    let midpoints = (0..coarse.edges()).into_par_iter().map(midpoint);
    let linear = coarse.mesh.points[..n].par_iter().copied().chain(midpoints);
    let displacements = &displacements[..fine.vertices()];
    linear.zip(displacements).map(|(point, &displacement)| add(point, displacement)).collect()
}

/// The facets of the coarse surfaces.
struct Facets<'a> {
    points: &'a [Vector3],
    topology: &'a Topology,
    strata: &'a Strata,
    all_the_way: bool,
    /// A displacement as short as this is rounding.
    rounding: f64,
}

impl Facets<'_> {
    fn midpoint(&self, [a, b]: [u32; 2]) -> Vector3 {
        scale(0.5, add(self.points[a as usize], self.points[b as usize]))
    }

    /// How far the new vertex of an edge is moved from the midpoint. On a flat face not at
    /// all: else rows that read the face alone could not be made exact.
    fn displacement(&self, edge: u32, limit: Vector3) -> Vector3 {
        let displacement = self.towards(edge, limit);
        if length(displacement) <= self.rounding { [0.0; 3] } else { displacement }
    }

    fn towards(&self, edge: u32, limit: Vector3) -> Vector3 {
        let ends = self.topology.edges()[edge as usize];
        let to_limit = subtract(limit, self.midpoint(ends));
        match self.strata.edge_dimensions[edge as usize] {
            _ if self.all_the_way => to_limit,
            1 => {
                let [a, b] = ends.map(|v| self.points[v as usize]);
                let along = component(to_limit, subtract(b, a)).unwrap_or([0.0; 3]);
                subtract(to_limit, along)
            }
            // Two facets folded upon each other have no normal.
            _ => component(to_limit, self.normal(edge)).unwrap_or(to_limit),
        }
    }

    /// The normal at an edge of a surface, of either orientation: the mean of those of its
    /// two facets, weighted by their areas.
    fn normal(&self, edge: u32) -> Vector3 {
        let [a, b] = self.topology.edges()[edge as usize].map(|v| self.points[v as usize]);
        let thirds = self.strata.opposite_vertices(edge);
        let area = |third: &u32| cross(subtract(b, a), subtract(self.points[*third as usize], a));
        // The second facet has the edge the other way round.
        let signed = thirds.iter().zip([1.0, -1.0]).map(|(third, sign)| scale(sign, area(third)));
        signed.fold([0.0; 3], add)
    }
}

/// The part of a vector along a direction, if that is one.
fn component(vector: Vector3, direction: Vector3) -> Option<Vector3> {
    let size = length(direction);
    (size > 0.0).then(|| {
        let unit = scale(size.recip(), direction);
        scale(dot3(vector, unit), unit)
    })
}
