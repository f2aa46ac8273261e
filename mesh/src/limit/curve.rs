//! Limits of curve strata: uniform cubic B-splines, exact for every parameter.

use octruss_base::vector3::{Vector3, add, cross, length, scale, subtract};

use super::error::LimitError;
use crate::core::strata::Strata;
use crate::core::topology::Topology;

/// The limit of the curve strata of a mesh under the approximating schemes.
///
/// Points may be others than the mesh's own (virtual control points), one for
/// each vertex.
#[derive(Debug, Clone, Copy)]
pub struct LimitCurves<'a> {
    topology: &'a Topology,
    strata: &'a Strata,
    points: &'a [Vector3],
}

/// A point of a curve with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// In mesh units.
    pub position: Vector3,
    /// With respect to the parameter of the edge, in mesh units.
    pub first: Vector3,
    /// The second derivative with respect to the parameter, in mesh units.
    pub second: Vector3,
}

impl CurvePoint {
    /// ‖x' × x''‖ / ‖x'‖³, one over mesh units; `None` where x' vanishes.
    pub fn curvature(&self) -> Option<f64> {
        let speed = length(self.first);
        (speed > 0.0).then(|| length(cross(self.first, self.second)) / speed.powi(3))
    }
}

impl<'a> LimitCurves<'a> {
    /// Of a mesh with this topology and these strata.
    ///
    /// # Errors
    /// If the points are not as many as the vertices.
    pub fn new(
        topology: &'a Topology,
        strata: &'a Strata,
        points: &'a [Vector3],
    ) -> Result<Self, LimitError> {
        let vertices = topology.vertex_count();
        if points.len() != vertices {
            return Err(LimitError::Points { points: points.len(), vertices });
        }
        Ok(Self { topology, strata, points })
    }

    /// The limit on a curve edge, `t` = 0 at its lower end and 1 at its higher.
    ///
    /// # Errors
    /// If there is no such edge, it is on no curve, one of its ends is a dart,
    /// or `t` is outside [0, 1].
    pub fn evaluate(&self, edge: u32, t: f64) -> Result<CurvePoint, LimitError> {
        if !(0.0..=1.0).contains(&t) {
            return Err(LimitError::OutsideEdge { t });
        }
        let controls = self.controls(edge)?;
        Ok(on_segment(controls, t))
    }

    /// The four control points of an edge's segment.
    fn controls(&self, edge: u32) -> Result<[Vector3; 4], LimitError> {
        let edges = self.topology.edges();
        let Some(&[a, b]) = edges.get(edge as usize) else {
            return Err(LimitError::NoEdge { edge, edges: edges.len() });
        };
        if self.strata.edge_dimensions[edge as usize] != 1 {
            return Err(LimitError::NotOnCurve { edge });
        }
        let [p, q] = [a, b].map(|v| self.points[v as usize]);
        Ok([self.beyond(edge, a, b)?, p, q, self.beyond(edge, b, a)?])
    }

    /// The control point before `end`, seen from `other`.
    ///
    /// At a fixed end it is the ghost 2 `end` − `other`, by which the rule of a
    /// curve vertex leaves the end where it is; the ghost of the refined curve
    /// is the refined ghost, so the segment is a B-spline's like any other.
    fn beyond(&self, edge: u32, end: u32, other: u32) -> Result<Vector3, LimitError> {
        let at = |v: u32| self.points[v as usize];
        match self.strata.vertex_dimensions[end as usize] {
            0 => Ok(subtract(scale(2.0, at(end)), at(other))),
            1 => match *self.strata.curve_neighbours(end) {
                [next, same] | [same, next] if same == other => Ok(at(next)),
                _ => Err(LimitError::NotOnCurve { edge }),
            },
            _ => Err(LimitError::EndsInDart { edge, vertex: end }),
        }
    }
}

/// The uniform cubic B-spline between the second and third of four points.
fn on_segment(controls: [Vector3; 4], t: f64) -> CurvePoint {
    let s = 1.0 - t;
    // From the first end: differences keep the digits of derivatives.
    let origin = controls[1];
    let differences = controls.map(|p| subtract(p, origin));
    let sum = |weights: [f64; 4]| {
        let parts = weights.into_iter().zip(differences).map(|(w, d)| scale(w, d));
        parts.fold([0.0; 3], add)
    };
    let basis =
        [s * s * s, (3.0 * t - 6.0) * t * t + 4.0, (3.0 * s - 6.0) * s * s + 4.0, t * t * t];
    let slope = [-s * s, (3.0 * t - 4.0) * t, (4.0 - 3.0 * s) * s, t * t];
    CurvePoint {
        position: add(origin, sum(basis.map(|w| w / 6.0))),
        first: sum(slope.map(|w| 0.5 * w)),
        second: sum([s, 3.0 * t - 2.0, 3.0 * s - 2.0, t]),
    }
}
