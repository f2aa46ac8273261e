//! Distances between a finite-element function and an exact solution.

use crate::element::p1::gradient;
use crate::element::quadrature::{DEGREE_5, position};
use octruss_base::chunks::map_ranges;
use octruss_mesh::TetMesh;

/// ‖u_h − u‖ in L², by a rule of degree 5 a tet; `u_h` has a value a vertex.
///
/// # Panics
/// Here and below: if `u_h` has fewer values than the mesh has vertices.
pub fn l2_error(mesh: &TetMesh, u_h: &[f64], exact: impl Fn([f64; 3]) -> f64 + Sync) -> f64 {
    integral(mesh, |tet, barycentric, at| {
        let values = mesh.tets()[tet].map(|v| u_h[v as usize]);
        let value: f64 = (0..4).map(|i| values[i] * barycentric[i]).sum();
        (value - exact(at)).powi(2)
    })
    .sqrt()
}

/// ‖∇u_h − ∇u‖ in L², by a rule of degree 5 a tet.
pub fn h1_seminorm_error(
    mesh: &TetMesh,
    u_h: &[f64],
    exact_gradient: impl Fn([f64; 3]) -> [f64; 3] + Sync,
) -> f64 {
    integral(mesh, |tet, _, at| {
        let values = mesh.tets()[tet].map(|v| u_h[v as usize]);
        let slope = gradient(mesh.corners(tet), values);
        let exact = exact_gradient(at);
        (0..3).map(|k| (slope[k] - exact[k]).powi(2)).sum()
    })
    .sqrt()
}

/// The integral of `integrand(tet, barycentric coordinates, position)`.
fn integral(mesh: &TetMesh, integrand: impl Fn(usize, &[f64; 4], [f64; 3]) -> f64 + Sync) -> f64 {
    let sums = map_ranges(mesh.tets().len(), |tets| {
        let over_tet = |tet: usize| {
            let corners = mesh.corners(tet);
            let values = DEGREE_5.iter().map(|(b, w)| w * integrand(tet, b, position(&corners, b)));
            mesh.volume(tet) * values.sum::<f64>()
        };
        tets.map(over_tet).sum::<f64>()
    });
    sums.iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use octruss_mesh::shapes::five_tet_cube;

    #[test]
    fn norms_of_known_functions() {
        let mesh = five_tet_cube();
        let zero = vec![0.0; mesh.points().len()];
        // ∫ x⁴ = 1/5 and ∫ |∇x²|² = ∫ 4x² = 4/3 over the unit cube.
        assert!((l2_error(&mesh, &zero, |[x, ..]| x * x).powi(2) - 0.2).abs() < 1e-14);
        let slope = |[x, ..]: [f64; 3]| [2.0 * x, 0.0, 0.0];
        assert!((h1_seminorm_error(&mesh, &zero, slope).powi(2) - 4.0 / 3.0).abs() < 1e-14);
        let linear: Vec<f64> = mesh.points().iter().map(|p| 1.0 + p[0] - 2.0 * p[2]).collect();
        assert!(l2_error(&mesh, &linear, |[x, _, z]| 1.0 + x - 2.0 * z) < 1e-15);
        assert!(h1_seminorm_error(&mesh, &linear, |_| [1.0, 0.0, -2.0]) < 1e-14);
    }
}
