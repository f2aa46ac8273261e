//! Rigid motions, linear as strains are: t + ω × (x − c) / s.

use nalgebra::Vector6;
use octruss_base::vector3::{Vector3, add, cross, scale, subtract};

/// t + ω × (x − c) / s: of six numbers of one size, where s is that of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RigidMotion {
    /// c.
    pub(crate) centre: Vector3,
    /// s.
    pub(crate) size: f64,
    /// ω, then t.
    pub(crate) motion: [f64; 6],
}

impl RigidMotion {
    /// The displacement of a point.
    #[inline]
    pub(crate) fn at(&self, point: Vector3) -> Vector3 {
        let [a, b, c, x, y, z] = self.motion;
        let arm = scale(1.0 / self.size, subtract(point, self.centre));
        add([x, y, z], cross([a, b, c], arm))
    }

    /// What the six numbers are to be multiplied with for the displacement of a point along
    /// a vector: v · (t + ω × a) = v · t + (a × v) · ω.
    pub(crate) fn moment(&self, point: Vector3, v: Vector3) -> Vector6<f64> {
        let [a, b, c] = cross(scale(1.0 / self.size, subtract(point, self.centre)), v);
        Vector6::new(a, b, c, v[0], v[1], v[2])
    }

    /// ω / s: how far it turns, in radians, as a vector along the axis.
    pub(crate) fn turn(&self) -> Vector3 {
        let [a, b, c, ..] = self.motion;
        scale(1.0 / self.size, [a, b, c])
    }

    /// The same motion with other numbers.
    pub(crate) fn with(&self, motion: [f64; 6]) -> Self {
        Self { motion, ..*self }
    }
}
