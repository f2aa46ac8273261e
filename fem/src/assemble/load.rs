//! Load vectors: integrals of sources over tets and of fluxes over triangles.
//!
//! Constants are integrated exactly; functions by rules of degree 2 (four
//! points a tet, three a triangle), which leaves an L² rate of 2 intact.

use crate::element::p1::{scaled_gradients, triangle_area};
use crate::element::quadrature::{DEGREE_2, TRIANGLE_DEGREE_2, position};

/// ∫ f φ over a tet, for each corner.
#[inline]
pub(crate) fn tet_load<const K: usize>(
    corners: [[f64; 3]; 4],
    is_constant: bool,
    f: impl Fn([f64; 3]) -> [f64; K],
) -> [[f64; K]; 4] {
    // As the stiffness has it, so that one pass for both need not compute it twice.
    let volume = scaled_gradients(corners).0 / 6.0;
    if is_constant {
        return [f(corners[0]).map(|value| 0.25 * volume * value); 4];
    }
    let mut load = [[0.0; K]; 4];
    for (point, weight) in DEGREE_2 {
        let value = f(position(&corners, point));
        for (load, shape) in load.iter_mut().zip(point) {
            (0..K).for_each(|k| load[k] += weight * volume * value[k] * shape);
        }
    }
    load
}

/// ∫ g φ over a triangle, for each corner.
pub(crate) fn triangle_load<const K: usize>(
    corners: [[f64; 3]; 3],
    is_constant: bool,
    g: impl Fn([f64; 3]) -> [f64; K],
) -> [[f64; K]; 3] {
    let area = triangle_area(corners);
    if is_constant {
        return [g(corners[0]).map(|value| area * value / 3.0); 3];
    }
    let mut load = [[0.0; K]; 3];
    for (point, weight) in TRIANGLE_DEGREE_2 {
        let value = g(position(&corners, point));
        for (load, shape) in load.iter_mut().zip(point) {
            (0..K).for_each(|k| load[k] += weight * area * value[k] * shape);
        }
    }
    load
}

/// Adds what the corners of a simplex get.
pub(crate) fn add_at<const K: usize, const N: usize>(
    load: &mut [[f64; K]],
    vertices: [u32; N],
    values: [[f64; K]; N],
) {
    for (vertex, value) in vertices.into_iter().zip(values) {
        (0..K).for_each(|k| load[vertex as usize][k] += value[k]);
    }
}
