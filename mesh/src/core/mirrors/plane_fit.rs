//! The plane through the triangles of a surface group.

use crate::core::raw_mesh::RawMesh;
use octruss_base::vector3::{Vector3, add, cross, dot3, length, subtract};

/// The plane { x : normal · x = place } nearest to some triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlaneFit {
    /// A unit vector, to either side.
    pub normal: Vector3,
    /// In mesh units.
    pub place: f64,
}

impl PlaneFit {
    /// Through the triangles of a surface group; none if they have no area.
    pub fn new(mesh: &RawMesh, group: i32) -> Option<Self> {
        let triangles = mesh.triangles.iter().filter(|&(_, tag)| tag == group);
        let corners: Vec<[Vector3; 3]> =
            triangles.map(|(triangle, _)| triangle.map(|v| mesh.points[v as usize])).collect();
        let normal = mean_normal(&corners)?;
        // The middle between the outermost is exact where all are at one place.
        let places = corners.as_flattened().iter().map(|&point| dot3(point, normal));
        let [least, most] = places.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| {
            [least.min(x), most.max(x)]
        });
        Some(Self { normal, place: 0.5 * (least + most) })
    }

    /// How far in front of the plane a point is.
    pub fn height(&self, point: Vector3) -> f64 {
        dot3(point, self.normal) - self.place
    }
}

/// Weighted by areas, whatever the orientation of each triangle.
fn mean_normal(triangles: &[[Vector3; 3]]) -> Option<Vector3> {
    let mut sum = [0.0; 3];
    for &[a, b, c] in triangles {
        let normal = cross(subtract(b, a), subtract(c, a));
        let sign = if dot3(sum, normal) < 0.0 { -1.0 } else { 1.0 };
        sum = add(sum, normal.map(|x| sign * x));
    }
    unit(sum)
}

/// Quotients, not a product with the inverse: an axis of coordinates stays one.
pub(super) fn unit(vector: Vector3) -> Option<Vector3> {
    let size = length(vector);
    (size > 0.0).then(|| vector.map(|x| x / size))
}
