//! Geometry of one linear tet: volume and gradients of its shape functions.

use octruss_mesh::reference_tet::{EDGES, FACES, six_volumes};

/// Six times the volume, and for each vertex the gradient of its shape
/// function times six volumes: the cross product of the edges of the opposite
/// face, pointing inward.
#[inline]
pub(crate) fn scaled_gradients(corners: [[f64; 3]; 4]) -> (f64, [[f64; 3]; 4]) {
    let gradients = FACES.map(|face| {
        let [a, b, c] = face.map(|v| corners[v]);
        cross(subtract(c, a), subtract(b, a))
    });
    (six_volumes(corners), gradients)
}

/// ∫ ∇φa · ∇φb over the tet for its six edges ab, in mesh units.
#[inline]
pub(crate) fn edge_stiffness(corners: [[f64; 3]; 4]) -> [f64; 6] {
    let (six_volumes, gradients) = scaled_gradients(corners);
    let scale = 1.0 / (6.0 * six_volumes);
    EDGES.map(|[a, b]| scale * dot3(gradients[a], gradients[b]))
}

/// The gradient of the linear function with these values at the corners.
pub(crate) fn gradient(corners: [[f64; 3]; 4], values: [f64; 4]) -> [f64; 3] {
    let (six_volumes, gradients) = scaled_gradients(corners);
    std::array::from_fn(|k| (0..4).map(|i| gradients[i][k] * values[i]).sum::<f64>() / six_volumes)
}

/// The area of a triangle.
pub(crate) fn triangle_area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let normal = cross(subtract(b, a), subtract(c, a));
    0.5 * dot3(normal, normal).sqrt()
}

/// The mean of the corners.
#[inline]
pub(crate) fn centroid(corners: [[f64; 3]; 4]) -> [f64; 3] {
    std::array::from_fn(|k| 0.25 * corners.iter().map(|corner| corner[k]).sum::<f64>())
}

#[inline]
fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

#[inline]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
fn dot3(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
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
}
