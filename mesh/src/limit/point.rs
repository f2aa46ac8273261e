//! What is known of a limit surface at one place.

use octruss_base::vector3::{Vector3, dot3};

use super::corner::unit_normal;

/// A point of a limit surface with what shapes it there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// In mesh units.
    pub position: Vector3,
    /// ∂/∂u and ∂/∂v, in mesh units. At an extraordinary corner, where these are
    /// zero or infinite or differ by direction, two vectors that span the
    /// surface there, turned the same way.
    pub tangents: [Vector3; 2],
    /// ∂²/∂u², ∂²/∂u∂v and ∂²/∂v², in mesh units; `None` at an extraordinary
    /// corner.
    pub second: Option<[Vector3; 3]>,
    /// The unit normal: out of the solid on the boundary; on an interface out of
    /// the region of the smaller number; elsewhere right-handed with the
    /// tangents. `None` where the surface has none.
    pub normal: Option<Vector3>,
    /// The principal curvatures, the smaller first, in one over mesh units;
    /// positive where the surface bends towards the normal, so negative on a
    /// ball. `None` at an extraordinary corner and where there is no normal.
    pub curvatures: Option<[f64; 2]>,
}

impl SurfacePoint {
    /// From derivatives; `flip` where the normal is −∂u × ∂v.
    pub(super) fn regular(
        position: Vector3,
        tangents: [Vector3; 2],
        second: [Vector3; 3],
        flip: bool,
    ) -> Self {
        let normal = oriented(unit_normal(tangents), flip);
        let curvatures = normal.map(|normal| curvatures(tangents, second, normal));
        Self { position, tangents, second: Some(second), normal, curvatures }
    }
}

/// A normal, turned round if asked.
pub(super) fn oriented(normal: Option<Vector3>, flip: bool) -> Option<Vector3> {
    normal.map(|normal| if flip { normal.map(|x| -x) } else { normal })
}

/// The eigenvalues of the second fundamental form by the first.
fn curvatures([u, v]: [Vector3; 2], second: [Vector3; 3], normal: Vector3) -> [f64; 2] {
    let (e, f, g) = (dot3(u, u), dot3(u, v), dot3(v, v));
    let [l, m, n] = second.map(|d| dot3(d, normal));
    let area = e * g - f * f;
    let mean = 0.5 * (e * n - 2.0 * f * m + g * l) / area;
    let gauss = (l * n - m * m) / area;
    let half = (mean * mean - gauss).max(0.0).sqrt();
    [mean - half, mean + half]
}
