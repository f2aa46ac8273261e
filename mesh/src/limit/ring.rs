//! A triangle with all that its limit depends on: the fans of its corners.

use octruss_base::vector3::{Vector3, subtract};

use super::fan::Fan;
use super::spline_patch::Patch;

/// A triangle of some level with the fans of its corners, which are closed
/// under subdivision: the ring of each of its four children follows from it.
///
/// Points are differences from an origin that goes with the triangle, so that
/// what is small stays exact however deep the recursion is.
#[derive(Debug, Clone)]
pub(super) struct Ring {
    pub origin: Vector3,
    pub corners: [Vector3; 3],
    /// Fan i counts its neighbours from corner i + 1.
    pub fans: [Fan; 3],
}

impl Ring {
    /// The control points of the patch, if all corners are regular.
    pub fn patch(&self) -> Option<Patch> {
        let [a, b, c] = self.corners;
        let [at_a, at_b, at_c] = [0, 1, 2].map(|i| self.fans[i].hexagon(self.corners[i]));
        let (at_a, at_b, at_c) = (at_a?, at_b?, at_c?);
        Some([
            a, b, c, at_b[5], at_c[3], at_c[4], at_a[2], at_a[3], at_a[4], at_a[5], at_b[3],
            at_b[4],
        ])
    }

    /// Makes another point, given as a difference from the old, the origin.
    pub fn rebased(mut self, to: Vector3) -> Self {
        self.origin = octruss_base::vector3::add(self.origin, to);
        self.corners.iter_mut().for_each(|corner| *corner = subtract(*corner, to));
        self.fans.iter_mut().for_each(|fan| fan.shift(to));
        self
    }
}
