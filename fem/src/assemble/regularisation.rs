//! How much to add to the diagonal of a free part.

use crate::element::p1::centroid;
use crate::free::free_bodies::SHIFT;
use octruss_base::vector3::{Vector3, add, dot3, scale, subtract};
use octruss_mesh::TetMesh;

/// For each part, given by its vertices, the shift of its vertices with these volumes, for a
/// stiffness by tet and position: SHIFT K / r² times the volume, with the mean K of the
/// stiffness, its logarithm averaged, and the radius r of gyration. K / r² is the Rayleigh
/// quotient of a uniform stretch, and so near the smallest eigenvalue of a compact part.
pub(crate) fn shifts<'a>(
    mesh: &TetMesh,
    parts: impl Iterator<Item = &'a [u32]> + Clone,
    volumes: &[f64],
    stiffness: impl Fn(usize, Vector3) -> f64,
) -> Vec<f64> {
    const NONE: usize = usize::MAX;
    let mut part_of = vec![NONE; volumes.len()];
    for (number, vertices) in parts.clone().enumerate() {
        vertices.iter().for_each(|&vertex| part_of[vertex as usize] = number);
    }
    let mut logarithms = vec![[0.0; 2]; parts.clone().count()];
    for (tet, vertices) in mesh.tets().iter().enumerate() {
        let part = part_of[vertices[0] as usize];
        if part != NONE {
            let (volume, middle) = (mesh.volume(tet), centroid(mesh.corners(tet)));
            logarithms[part][0] += volume;
            logarithms[part][1] += volume * stiffness(tet, middle).ln();
        }
    }
    let mut shifts = vec![0.0; volumes.len()];
    for (vertices, [volume, logarithm]) in parts.zip(logarithms) {
        let mean = (logarithm / volume).exp();
        let shift = SHIFT * mean * volume / second_moment(mesh, vertices, volumes);
        for &vertex in vertices {
            shifts[vertex as usize] = shift * volumes[vertex as usize];
        }
    }
    shifts
}

/// Σ w |x − c|² of some vertices with weights, c their centre.
fn second_moment(mesh: &TetMesh, vertices: &[u32], weights: &[f64]) -> f64 {
    let centre = weighted_centre(mesh, vertices, weights);
    let moment = |&vertex: &u32| {
        let arm = subtract(mesh.points()[vertex as usize], centre);
        weights[vertex as usize] * dot3(arm, arm)
    };
    vertices.iter().map(moment).sum()
}

/// The centre of some vertices with weights.
pub(crate) fn weighted_centre(mesh: &TetMesh, vertices: &[u32], weights: &[f64]) -> Vector3 {
    let origin = mesh.points()[vertices[0] as usize];
    let (mut total, mut sum) = (0.0, [0.0; 3]);
    for &vertex in vertices {
        let weight = weights[vertex as usize];
        total += weight;
        sum = add(sum, scale(weight, subtract(mesh.points()[vertex as usize], origin)));
    }
    add(origin, scale(1.0 / total, sum))
}
