//! From a triangle down to the regular patch that holds a place.

use octruss_base::vector3::Vector3;

use super::ring::{Ring, Surroundings};
use super::spline_patch::Patch;
use crate::limit::fan::Fan;

/// How near a corner (u, v) is the corner itself: there even the slowest
/// eigenvalue, 5/8, has brought all points together in double precision.
const AT_CORNER: f64 = 1.0 / (1u128 << 127) as f64;

/// What a recursion ends in.
pub(in crate::limit) enum Reached {
    Patch(SubPatch),
    Corner(SubCorner),
}

/// A regular patch inside a triangle.
pub(in crate::limit) struct SubPatch {
    pub origin: Vector3,
    pub controls: Patch,
    pub uv: [f64; 2],
    /// Derivatives by the triangle's coordinates over those by the patch's.
    pub scale: f64,
}

/// An extraordinary corner of a triangle inside a triangle.
pub(in crate::limit) struct SubCorner {
    pub origin: Vector3,
    pub centre: Vector3,
    pub fan: Fan,
}

/// Subdivides a ring towards a place until that lies in a regular patch
/// (Wang's Table 5-1, without its end at a fixed depth).
#[inline]
pub(in crate::limit) fn descend(ring: Ring, uv: [f64; 2]) -> Reached {
    let origin = ring.origin;
    match ring.patch() {
        Some(controls) => Reached::Patch(SubPatch { origin, controls, uv, scale: 1.0 }),
        None => descend_further(ring, uv),
    }
}

fn descend_further(mut ring: Ring, uv: [f64; 2]) -> Reached {
    let mut at = inside(uv);
    let mut scale = 1.0;
    loop {
        let origin = ring.origin;
        if let Some(controls) = ring.patch() {
            return Reached::Patch(SubPatch { origin, controls, uv: [at[1], at[2]], scale });
        }
        let Some(i) = (0..3).find(|&i| at[i] >= 0.5) else {
            let controls = ring.middle_patch();
            let uv = [1.0 - 2.0 * at[1], 1.0 - 2.0 * at[2]];
            return Reached::Patch(SubPatch { origin, controls, uv, scale: -2.0 * scale });
        };
        let others = at[(i + 1) % 3].max(at[(i + 2) % 3]);
        if let Surroundings::Extraordinary(fan) = &ring.round[i]
            && others < AT_CORNER
        {
            let (centre, fan) = (ring.corners[i], fan.clone());
            return Reached::Corner(SubCorner { origin, centre, fan });
        }
        ring.go_to_corner(i);
        // The last two are exact; the first is what they leave.
        (at[1], at[2]) = (2.0 * at[1], 2.0 * at[2]);
        if i > 0 {
            at[i] -= 1.0;
        }
        at[0] = 1.0 - at[1] - at[2];
        scale *= 2.0;
    }
}

/// The three barycentric coordinates; a sum above one is rounding, and is taken
/// off the larger.
fn inside([u, v]: [f64; 2]) -> [f64; 3] {
    if u + v < 1.0 {
        [1.0 - u - v, u, v]
    } else if u < v {
        [0.0, u, 1.0 - u]
    } else {
        [0.0, 1.0 - v, v]
    }
}
