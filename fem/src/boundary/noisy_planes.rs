//! Which normals are those of a coordinate plane but for noise in its coordinates.
//!
//! Half of a plane may be held by its component, `x = 0`, and half by its normal. With noise
//! of a few percent of an edge the normals are off by degrees, and at the common vertices two
//! nearly equal directions would be held, which clamps them sideways. No fixed angle tells
//! this from a real taper of 1°; the surface round the vertex does. The triangles within 5°
//! of an axis that hang together are a plane across that axis if their mean normal is no
//! further off it than their scatter about the mean. So a clean taper counts from
//! [`SAME_DIRECTION`] on, a noisy one as soon as it is greater than its noise. Of a curved
//! surface the strip that faces the axis counts as across it, too: there, on the border with
//! what is held by this very component, it is.

use crate::boundary::held_vertex::SAME_DIRECTION;
use crate::boundary::surface_normals::{Facet, VertexNormal};
use octruss_base::disjoint_sets::DisjointSets;
use octruss_base::vector3::{IDENTITY, Vector3, add, dot3, scale};

/// The cosine of 5°.
const NEAR: f64 = 0.996_194_698_091_746;

/// For each normal the direction that it stands for: an axis, or itself.
pub(crate) fn meant_directions(facets: &[Facet], normals: &[VertexNormal]) -> Vec<Vector3> {
    let mut vertices: Vec<u32> = normals.iter().map(|normal| normal.vertex).collect();
    vertices.dedup();
    let mut meant: Vec<Vector3> = normals.iter().map(|normal| normal.normal).collect();
    for axis in IDENTITY.into_iter().flat_map(|axis| [axis, scale(-1.0, axis)]) {
        let near = |normal: Vector3| dot3(normal, axis) > NEAR;
        let facets: Vec<&Facet> = facets.iter().filter(|facet| near(facet.normal)).collect();
        if facets.is_empty() {
            continue;
        }
        let planes = planes_across(axis, &facets, &vertices);
        let mut at = 0;
        for (normal, meant) in normals.iter().zip(&mut meant) {
            while vertices[at] != normal.vertex {
                at += 1;
            }
            if planes[at] && near(normal.normal) {
                *meant = axis;
            }
        }
    }
    meant
}

/// Whether each vertex (ascending) is on a plane across the axis, up to noise, of triangles
/// near it.
fn planes_across(axis: Vector3, facets: &[&Facet], vertices: &[u32]) -> Vec<bool> {
    let place = |vertex: u32| vertices.partition_point(|v| *v < vertex) as u32;
    let mut regions = DisjointSets::new(vertices.len());
    for [a, b, c] in facets.iter().map(|facet| facet.vertices.map(place)) {
        regions.join(a, b);
        regions.join(a, c);
    }
    // For each region, at its lowest vertex, area and sum of area times normal.
    let mut sums = vec![(0.0, [0.0; 3]); vertices.len()];
    for facet in facets {
        let (area, sum) = &mut sums[regions.lowest(place(facet.vertices[0])) as usize];
        *area += facet.double_area;
        *sum = add(*sum, scale(facet.double_area, facet.normal));
    }
    let is_plane = |&(area, sum): &(f64, Vector3)| {
        let mean = scale(1.0 / area, sum);
        let along = dot3(mean, axis);
        let off = (dot3(mean, mean) - along * along) / dot3(mean, mean);
        // Normals have length 1: their mean square about the mean.
        let scatter = 1.0 - dot3(mean, mean);
        area > 0.0 && off <= scatter.max(SAME_DIRECTION * SAME_DIRECTION)
    };
    let planes: Vec<bool> = sums.iter().map(is_plane).collect();
    (0..vertices.len() as u32).map(|at| planes[regions.lowest(at) as usize]).collect()
}
