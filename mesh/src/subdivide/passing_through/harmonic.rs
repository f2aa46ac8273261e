//! Control points of the solid that go with those of its boundary.

use super::block::Block;
use crate::core::mirrors::Unfolded;
use crate::core::topology::VertexEdges;
use octruss_base::large_array::filled;
use octruss_base::vector3::{Vector3, add, subtract};

/// How far an equation may be missed, in the units of its right-hand side's largest.
const SMALL: f64 = 1e-6;

/// Moves the control points of vertices that are not listed, which stand at their
/// positions, by the harmonic extension of how far the listed ones stand from theirs:
/// everywhere the mean of the neighbours.
pub(super) fn extend(coarse: &Unfolded, listed: &[u32], control_points: &mut [Vector3]) {
    let topology = &*coarse.topology;
    let incident = VertexEdges::new(topology);
    let neighbours = |v: u32| {
        let edges = incident.of(v as usize).iter();
        edges.map(move |&edge| topology.edges()[edge as usize]).map(move |[a, b]| a ^ b ^ v)
    };
    let inner = (0..coarse.vertices() as u32).filter(|v| listed.binary_search(v).is_err());
    let inner: Vec<u32> = inner.filter(|&v| !incident.of(v as usize).is_empty()).collect();
    let degree = |v: u32| incident.of(v as usize).len() as f64;
    let block = Block::new(inner, coarse, (degree, -1.0), neighbours);
    // Those that are unknown have not moved yet.
    let mut moved = filled([0.0; 3], topology.vertex_count());
    for (moved, (&to, &from)) in
        moved.iter_mut().zip(control_points.iter().zip(&*coarse.mesh.points))
    {
        *moved = subtract(to, from);
    }
    coarse.turn_images(&mut moved);
    let sum = |v: &u32| neighbours(*v).map(|v| moved[v as usize]).fold([0.0; 3], add);
    let rhs: Vec<Vector3> = block.vertices.iter().map(sum).collect();
    let most = rhs.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let is_small = |_, rest: Vector3| rest.iter().all(|x| x.abs() <= SMALL * most);
    let (extension, _) = block.solve(rhs, is_small);
    for (&vertex, moved) in block.vertices.iter().zip(extension) {
        let place = &mut control_points[vertex as usize];
        *place = add(*place, moved);
    }
}
