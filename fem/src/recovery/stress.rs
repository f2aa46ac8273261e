//! Strain and stress from displacements, a tensor for each tet, on which linear
//! elements have them constant.
//!
//! Symmetric tensors are six components in the order of VTK: xx, yy, zz, xy, yz,
//! xz. Strains are those of the tensor: ε_xy = (∂u_x/∂y + ∂u_y/∂x) / 2, half of
//! the engineer's γ_xy.

use crate::assemble::elasticity::lame;
use crate::element::p1::{centroid, vector_gradient};
use crate::error::Error;
use crate::problem::elasticity::Elasticity;
use octruss_base::chunks::for_chunks;
use octruss_base::large_array::filled;
use octruss_base::vector3::Matrix3;
use octruss_mesh::TetMesh;
use octruss_solver::check_size;

/// The row and column of each of the six components.
pub(crate) const COMPONENTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];

/// The strain of each tet from the displacement of each vertex.
///
/// # Errors
/// [`octruss_solver::Error::Size`] unless there is one displacement for each vertex.
pub fn strains(mesh: &TetMesh, displacement: &[[f64; 3]]) -> Result<Vec<[f64; 6]>, Error> {
    check_size("displacements", displacement.len(), mesh.points().len())?;
    Ok(each(mesh.tets().len(), [0.0; 6], |tet| {
        let values = mesh.tets()[tet].map(|v| displacement[v as usize]);
        let gradient = vector_gradient(mesh.corners(tet), values);
        COMPONENTS.map(|(i, j)| 0.5 * (gradient[i][j] + gradient[j][i]))
    }))
}

/// The stress of each tet, λ tr(ε) I + 2 μ ε, from its strain.
///
/// # Errors
/// [`octruss_solver::Error::Size`] unless there is one strain for each tet.
pub fn stresses(
    mesh: &TetMesh,
    problem: &Elasticity,
    strains: &[[f64; 6]],
) -> Result<Vec<[f64; 6]>, Error> {
    check_size("strains", strains.len(), mesh.tets().len())?;
    Ok(each(mesh.tets().len(), [0.0; 6], |tet| {
        let material = problem.material.of(mesh.regions()[tet]);
        let [lambda, mu] = lame(material, centroid(mesh.corners(tet)));
        let strain = strains[tet];
        let volume_change = strain[0] + strain[1] + strain[2];
        std::array::from_fn(|k| {
            2.0 * mu * strain[k] + if k < 3 { lambda * volume_change } else { 0.0 }
        })
    }))
}

/// Von Mises' equivalent stress: √(3/2) times the size of the stress less its
/// mean; the stress itself where only one direction is pulled.
pub fn von_mises(stress: &[f64; 6]) -> f64 {
    let [xx, yy, zz, xy, yz, xz] = *stress;
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * normal + 3.0 * (xy * xy + yz * yz + xz * xz)).sqrt()
}

/// Von Mises' equivalent stress of each of many, as [`von_mises`].
pub fn equivalent_stresses(stresses: &[[f64; 6]]) -> Vec<f64> {
    each(stresses.len(), 0.0, |k| von_mises(&stresses[k]))
}

/// The 3 × 3 matrix of a symmetric tensor.
#[inline]
pub(crate) fn full(tensor: &[f64; 6]) -> Matrix3 {
    let [xx, yy, zz, xy, yz, xz] = *tensor;
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// The value at each of `0..count`, from threads that write their parts of one array.
fn each<T: Copy + Send>(count: usize, zero: T, value: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let mut all = filled(zero, count);
    for_chunks(&mut all, |first, chunk| {
        chunk.iter_mut().enumerate().for_each(|(k, at)| *at = value(first + k));
    });
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn von_mises_of_simple_states() {
        assert_eq!(von_mises(&[7.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 7.0, "one direction");
        assert_eq!(von_mises(&[5.0, 5.0, 5.0, 0.0, 0.0, 0.0]), 0.0, "pressure");
        // Pure shear τ: √3 τ.
        assert!((von_mises(&[0.0, 0.0, 0.0, 0.0, 2.0, 0.0]) - 12.0_f64.sqrt()).abs() < 1e-15);
    }
}
