//! Geometry of one linear tet: volume and gradients of its shape functions.

use octruss_base::vector3::{Matrix3, add, cross, dot3, length, scale, subtract};
use octruss_mesh::reference_tet::EDGES;

/// Six times the volume, and for each vertex the gradient of its shape
/// function times six volumes: the cross product of the edges of the opposite
/// face, pointing inward.
#[inline]
pub(crate) fn scaled_gradients([o, a, b, c]: [[f64; 3]; 4]) -> (f64, [[f64; 3]; 4]) {
    let (a, b, c) = (subtract(a, o), subtract(b, o), subtract(c, o));
    let (at_a, at_b, at_c) = (cross(b, c), cross(c, a), cross(a, b));
    // Shape functions sum to one.
    let at_o = scale(-1.0, add(add(at_a, at_b), at_c));
    (dot3(a, at_a), [at_o, at_a, at_b, at_c])
}

/// ∫ ∇φa · ∇φb over the tet for its six edges ab, in mesh units.
#[inline]
pub(crate) fn edge_stiffness(corners: [[f64; 3]; 4]) -> [f64; 6] {
    let (six_volumes, gradients) = scaled_gradients(corners);
    let scale = 1.0 / (6.0 * six_volumes);
    EDGES.map(|[a, b]| scale * dot3(gradients[a], gradients[b]))
}

/// ∫ λ ∇φa ∇φbᵀ + μ (∇φb ∇φaᵀ + ∇φa · ∇φb I) over the tet for its six edges ab:
/// the 3 × 3 blocks of linear elasticity, row by row.
#[inline]
pub(crate) fn edge_elasticity(corners: [[f64; 3]; 4], lambda: f64, mu: f64) -> [[f64; 9]; 6] {
    let (six_volumes, gradients) = scaled_gradients(corners);
    let factor = 1.0 / (6.0 * six_volumes);
    let (lambda, mu) = (factor * lambda, factor * mu);
    EDGES.map(|[a, b]| {
        let (a, b) = (gradients[a], gradients[b]);
        let (lambda_a, mu_b) = (scale(lambda, a), scale(mu, b));
        let shear = dot3(a, mu_b);
        std::array::from_fn(|entry| {
            let (i, j) = (entry / 3, entry % 3);
            lambda_a[i] * b[j] + mu_b[i] * a[j] + if i == j { shear } else { 0.0 }
        })
    })
}

/// The gradient of the vector-valued linear function with these values at the
/// corners: row i holds the derivatives of component i.
pub(crate) fn vector_gradient(corners: [[f64; 3]; 4], values: [[f64; 3]; 4]) -> Matrix3 {
    let (six_volumes, gradients) = scaled_gradients(corners);
    std::array::from_fn(|i| {
        std::array::from_fn(|k| {
            (0..4).map(|v| values[v][i] * gradients[v][k]).sum::<f64>() / six_volumes
        })
    })
}

/// The gradient of the linear function with these values at the corners.
pub(crate) fn gradient(corners: [[f64; 3]; 4], values: [f64; 4]) -> [f64; 3] {
    let (six_volumes, gradients) = scaled_gradients(corners);
    std::array::from_fn(|k| (0..4).map(|i| gradients[i][k] * values[i]).sum::<f64>() / six_volumes)
}

/// The area of a triangle.
pub(crate) fn triangle_area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    0.5 * length(cross(subtract(b, a), subtract(c, a)))
}

/// The mean of the corners.
#[inline]
pub(crate) fn centroid(corners: [[f64; 3]; 4]) -> [f64; 3] {
    std::array::from_fn(|k| 0.25 * corners.iter().map(|corner| corner[k]).sum::<f64>())
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: [[f64; 3]; 4] =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    #[test]
    fn the_unit_tet_has_the_textbook_stiffness() {
        // Gradients (−1, −1, −1), e₁, e₂, e₃ and volume 1/6.
        let sixth = 1.0 / 6.0;
        assert_eq!(edge_stiffness(UNIT), [-sixth, -sixth, -sixth, 0.0, 0.0, 0.0]);
        assert_eq!(gradient(UNIT, [1.0, 3.0, 4.0, 5.0]), [2.0, 3.0, 4.0]);
        assert_eq!(centroid(UNIT), [0.25; 3]);
        assert_eq!(triangle_area([UNIT[0], UNIT[1], UNIT[2]]), 0.5);
    }

    #[test]
    fn the_unit_tet_has_the_textbook_elasticity() {
        // Edge x1 x2 with gradients e₁ and e₂, volume 1/6: λ e₁ e₂ᵀ + μ e₂ e₁ᵀ.
        let block = edge_elasticity(UNIT, 12.0, 6.0)[3];
        assert_eq!(block, [0.0, 2.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        // Edge x0 x1 with −(1, 1, 1) and e₁: −λ on the first column, −μ on the
        // first row, and −μ on the diagonal.
        let block = edge_elasticity(UNIT, 12.0, 6.0)[0];
        assert_eq!(block, [-4.0, -1.0, -1.0, -2.0, -1.0, 0.0, -2.0, 0.0, -1.0]);
        let values = [[1.0, 0.0, 0.0], [3.0, 0.0, 5.0], [1.0, 4.0, 0.0], [1.0, 0.0, 7.0]];
        let exact = [[2.0, 0.0, 0.0], [0.0, 4.0, 0.0], [5.0, 0.0, 7.0]];
        assert_eq!(vector_gradient(UNIT, values), exact);
    }
}
