//! The quartic box spline on one triangle of the regular lattice, from its
//! twelve control points.

use octruss_base::vector3::{Vector3, add, scale};

/// Where the control points lie in the lattice, by the barycentric frame of the
/// triangle: (0, 0), (1, 0) and (0, 1) are its corners, and the edges of the
/// lattice run along e1, e2 and e1 − e2.
///
/// Row by row the points are those of Wang's Equation 2.20:
/// (0, 0), (1, 0), (0, 1), (1, 1), (0, 2), (−1, 2), (−1, 1), (−1, 0), (0, −1),
/// (1, −1), (2, −1), (2, 0).
pub(in crate::limit) type Patch = [Vector3; 12];

/// The coefficients of each monomial, a row for each, a column for each control
/// point, times 12 (Wang's thesis, Equation 2.20, transposed).
#[rustfmt::skip]
const COEFFICIENTS: [[f64; 12]; 15] = [
    [  6.0,   1.0,   1.0,  0.0,  0.0,  0.0,  1.0,  1.0,  1.0,  1.0,  0.0,  0.0],
    [  0.0,   4.0,   2.0,  0.0,  0.0,  0.0, -2.0, -4.0, -2.0,  2.0,  0.0,  0.0],
    [  0.0,   2.0,   4.0,  0.0,  0.0,  0.0,  2.0, -2.0, -4.0, -2.0,  0.0,  0.0],
    [-12.0,   6.0,   0.0,  0.0,  0.0,  0.0,  0.0,  6.0,  0.0,  0.0,  0.0,  0.0],
    [-12.0,   6.0,   6.0,  0.0,  0.0,  0.0, -6.0,  6.0,  6.0, -6.0,  0.0,  0.0],
    [-12.0,   0.0,   6.0,  0.0,  0.0,  0.0,  0.0,  0.0,  6.0,  0.0,  0.0,  0.0],
    [  8.0,  -4.0,  -4.0,  2.0,  0.0,  0.0,  2.0, -4.0,  2.0, -4.0,  2.0,  0.0],
    [ 12.0,  -6.0, -12.0,  6.0,  0.0,  0.0,  6.0, -6.0,  0.0,  0.0,  0.0,  0.0],
    [ 12.0, -12.0,  -6.0,  6.0,  0.0,  0.0,  0.0,  0.0, -6.0,  6.0,  0.0,  0.0],
    [  8.0,  -4.0,  -4.0,  2.0,  0.0,  2.0, -4.0,  2.0, -4.0,  2.0,  0.0,  0.0],
    [ -1.0,  -1.0,   2.0, -1.0,  0.0,  0.0, -1.0,  1.0, -1.0,  2.0, -1.0,  1.0],
    [ -2.0,  -2.0,   4.0, -2.0,  0.0,  0.0, -2.0,  2.0, -2.0,  4.0, -2.0,  2.0],
    [  0.0,   0.0,   0.0,  0.0,  0.0,  0.0,  0.0,  0.0,  0.0,  0.0,  0.0,  0.0],
    [ -2.0,   4.0,  -2.0, -2.0,  2.0, -2.0,  4.0, -2.0,  2.0, -2.0,  0.0,  0.0],
    [ -1.0,   2.0,  -1.0, -1.0,  1.0, -1.0,  2.0, -1.0,  1.0, -1.0,  0.0,  0.0],
];

/// The value and the derivatives of a patch, in its own coordinates.
#[derive(Debug, Clone, Copy)]
pub(in crate::limit) struct PatchPoint {
    pub value: Vector3,
    /// ∂u and ∂v.
    pub first: [Vector3; 2],
    /// ∂uu, ∂uv and ∂vv.
    pub second: [Vector3; 3],
}

/// The point at (u, v).
#[inline]
pub(in crate::limit) fn value(patch: &Patch, [u, v]: [f64; 2]) -> Vector3 {
    combine(patch, monomials(u, v))
}

/// The point at (u, v) with first and second derivatives.
pub(in crate::limit) fn with_derivatives(patch: &Patch, [u, v]: [f64; 2]) -> PatchPoint {
    let (uu, uv, vv) = (u * u, u * v, v * v);
    let by_u = [
        0.0,
        1.0,
        0.0,
        2.0 * u,
        v,
        0.0,
        3.0 * uu,
        2.0 * uv,
        vv,
        0.0,
        4.0 * u * uu,
        3.0 * uu * v,
        2.0 * u * vv,
        v * vv,
        0.0,
    ];
    let by_v = [
        0.0,
        0.0,
        1.0,
        0.0,
        u,
        2.0 * v,
        0.0,
        uu,
        2.0 * uv,
        3.0 * vv,
        0.0,
        u * uu,
        2.0 * uu * v,
        3.0 * u * vv,
        4.0 * v * vv,
    ];
    let by_uu = [
        0.0,
        0.0,
        0.0,
        2.0,
        0.0,
        0.0,
        6.0 * u,
        2.0 * v,
        0.0,
        0.0,
        12.0 * uu,
        6.0 * uv,
        2.0 * vv,
        0.0,
        0.0,
    ];
    let by_uv = [
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        2.0 * u,
        2.0 * v,
        0.0,
        0.0,
        3.0 * uu,
        4.0 * uv,
        3.0 * vv,
        0.0,
    ];
    let by_vv = [
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        2.0,
        0.0,
        0.0,
        2.0 * u,
        6.0 * v,
        0.0,
        0.0,
        2.0 * uu,
        6.0 * uv,
        12.0 * vv,
    ];
    // Five sums over fifteen coefficients cost less than over twelve weights.
    let coefficients = coefficients(patch);
    let sum = |monomials: [f64; 15]| {
        let terms = monomials.into_iter().zip(&coefficients);
        terms.fold([0.0; 3], |sum, (m, &c)| add(sum, scale(m, c)))
    };
    PatchPoint {
        // The same sum, so the same bits, as without derivatives.
        value: value(patch, [u, v]),
        first: [sum(by_u), sum(by_v)],
        second: [sum(by_uu), sum(by_uv), sum(by_vv)],
    }
}

/// The coefficients of the monomials.
fn coefficients(patch: &Patch) -> [Vector3; 15] {
    COEFFICIENTS.map(|row| {
        let terms = row.into_iter().zip(patch);
        scale(1.0 / 12.0, terms.fold([0.0; 3], |sum, (c, &p)| add(sum, scale(c, p))))
    })
}

/// 1, u, v, u², uv, v², u³, u²v, uv², v³, u⁴, u³v, u²v², uv³, v⁴.
#[inline]
fn monomials(u: f64, v: f64) -> [f64; 15] {
    let (uu, uv, vv) = (u * u, u * v, v * v);
    [
        1.0,
        u,
        v,
        uu,
        uv,
        vv,
        uu * u,
        uu * v,
        u * vv,
        vv * v,
        uu * uu,
        uu * uv,
        uu * vv,
        uv * vv,
        vv * vv,
    ]
}

#[inline]
fn combine(patch: &Patch, monomials: [f64; 15]) -> Vector3 {
    let mut weights = [0.0; 12];
    for (monomial, row) in monomials.into_iter().zip(&COEFFICIENTS) {
        for (weight, coefficient) in weights.iter_mut().zip(row) {
            *weight += monomial * coefficient;
        }
    }
    let mut sum = [0.0; 3];
    for (weight, point) in weights.into_iter().zip(patch) {
        for (s, x) in sum.iter_mut().zip(point) {
            *s += weight * x;
        }
    }
    sum.map(|s| s / 12.0)
}
