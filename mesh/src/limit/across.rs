//! Which part of a displacement leads off a curve or surface.

use crate::core::raw_mesh::RawMesh;
use crate::core::strata::Strata;
use crate::core::topology::Topology;
use crate::limit::side::told_flipped;
use octruss_base::large_array::filled;
use octruss_base::vector3::{Vector3, add, cross, dot3, length, scale, subtract};

/// Tangents and normals at the vertices of curves and surfaces with given positions.
pub(super) struct Across<'a> {
    strata: &'a Strata,
    points: &'a [Vector3],
    /// The sum of the normals of the facets at each vertex, weighted by their areas; 0 off
    /// surfaces.
    normals: Vec<Vector3>,
}

impl<'a> Across<'a> {
    /// Facets are turned outwards on the boundary, away from the smaller region between
    /// two, elsewhere to the side of the first at a vertex.
    pub fn new(
        mesh: &RawMesh,
        topology: &Topology,
        strata: &'a Strata,
        points: &'a [Vector3],
    ) -> Self {
        let mut normals = filled([0.0; 3], points.len());
        for face in (0..topology.faces().len()).filter(|&face| strata.is_surface[face]) {
            let vertices = topology.faces()[face];
            let normal = normal(vertices, points);
            let flipped = told_flipped(topology, &mesh.tets, &mesh.regions, face as u32);
            let turn = flipped.map(|flipped| if flipped { -1.0 } else { 1.0 });
            for v in vertices {
                let sum = &mut normals[v as usize];
                let like_the_others = if dot3(*sum, normal) < 0.0 { -1.0 } else { 1.0 };
                *sum = add(*sum, scale(turn.unwrap_or(like_the_others), normal));
            }
        }
        Self { strata, points, normals }
    }

    /// How far a displacement of a vertex leads along the normal of its surface, or at
    /// right angles to its curve; its length at a corner, or where there is no direction.
    pub fn distance(&self, vertex: usize, displacement: Vector3) -> f64 {
        let whole = length(displacement);
        match self.strata.vertex_dimensions[vertex] {
            1 => {
                let [a, b] = match *self.strata.curve_neighbours(vertex as u32) {
                    [a, b] => [a, b].map(|v| self.points[v as usize]),
                    _ => return whole,
                };
                let tangent = subtract(b, a);
                along(tangent, displacement)
                    .map_or(whole, |along| (whole * whole - along * along).max(0.0).sqrt())
            }
            2 => along(self.normals[vertex], displacement).map_or(whole, f64::abs),
            _ => whole,
        }
    }
}

/// Twice the area of a triangle, as a vector.
fn normal(vertices: [u32; 3], points: &[Vector3]) -> Vector3 {
    let [a, b, c] = vertices.map(|v| points[v as usize]);
    cross(subtract(b, a), subtract(c, a))
}

/// The component along a direction, if that is one.
fn along(direction: Vector3, vector: Vector3) -> Option<f64> {
    let size = length(direction);
    (size > 0.0).then(|| dot3(direction, vector) / size)
}
