//! Where mirror planes are, and how points are reflected in them.

use super::cells::{Cell, OnPlanes, high, low};
use super::plane_fit::{PlaneFit, unit};
use crate::core::raw_mesh::RawMesh;
use octruss_base::vector3::{Vector3, add, dot3, length, scale};

/// The mirror planes of a mesh: perpendicular or parallel to each other, the mesh on one
/// side of each.
#[derive(Debug, Clone, PartialEq)]
pub struct Planes {
    /// Orthonormal; the normals are among them.
    axes: [Vector3; 3],
    /// The places of the low and the high plane along each axis; alike if there is one.
    offsets: [[f64; 2]; 3],
    /// The plane of each surface group; by ascending group.
    groups: Vec<(i32, OnPlanes)>,
}

impl Planes {
    /// Through the triangles of these surface groups; none if there are no triangles.
    pub fn of(mesh: &RawMesh, groups: &[i32]) -> Option<Self> {
        let fits = groups.iter().filter_map(|&group| Some((group, PlaneFit::new(mesh, group)?)));
        let fits: Vec<(i32, PlaneFit)> = fits.collect();
        let axes = frame(fits.iter().map(|(_, fit)| fit.normal));
        (!fits.is_empty()).then(|| {
            let middle = scale((mesh.points.len() as f64).recip(), sum(&mesh.points));
            let mut planes = Self { axes, offsets: [[f64::NAN; 2]; 3], groups: Vec::new() };
            for (group, fit) in fits {
                let axis = nearest(&axes, fit.normal);
                let place = fit.place * dot3(fit.normal, axes[axis]);
                let is_high = dot3(middle, axes[axis]) < place;
                planes.offsets[axis][usize::from(is_high)] = place;
                planes.groups.push((group, if is_high { high(axis) } else { low(axis) }));
            }
            for [low, high] in &mut planes.offsets {
                *low = if low.is_nan() { *high } else { *low };
                *high = if high.is_nan() { *low } else { *high };
            }
            planes
        })
    }

    /// The axes: a component along one is turned round by the planes across it, or by none.
    pub fn axes(&self) -> &[Vector3; 3] {
        &self.axes
    }

    /// The planes that each of so many vertices lies on, by the triangles of a mesh that
    /// was refined from the one the planes are of.
    pub fn at_vertices(&self, mesh: &RawMesh, vertices: usize) -> Vec<OnPlanes> {
        let mut on = vec![0; vertices];
        for (triangle, tag) in mesh.triangles.iter() {
            if let Ok(at) = self.groups.binary_search_by_key(&tag, |entry| entry.0) {
                triangle.iter().for_each(|&v| on[v as usize] |= self.groups[at].1);
            }
        }
        on
    }

    /// The image of a point in a cell.
    pub fn image(&self, point: Vector3, cell: Cell) -> Vector3 {
        let mut image = point;
        for (axis, &number) in cell.iter().enumerate().filter(|(_, number)| **number != 0) {
            let [low, high] = self.offsets[axis];
            let (place, thickness) = (dot3(point, self.axes[axis]), high - low);
            let moved = match number & 1 {
                0 => f64::from(number) * thickness,
                _ => 2.0 * (high - place) + f64::from(number - 1) * thickness,
            };
            image = add(image, scale(moved, self.axes[axis]));
        }
        image
    }

    /// Of these planes those that a point is on to the last bit.
    pub fn exactly_on(&self, point: Vector3, on: OnPlanes) -> OnPlanes {
        let is_on = |&(plane, axis, place): &(OnPlanes, usize, f64)| {
            on & plane != 0 && dot3(point, self.axes[axis]) == place
        };
        self.each().into_iter().filter(is_on).fold(0, |all, (plane, ..)| all | plane)
    }

    /// A point moved onto planes, each along its axis.
    pub fn moved_onto(&self, point: Vector3, on: OnPlanes) -> Vector3 {
        let planes = self.each().into_iter().filter(|(plane, ..)| on & plane != 0);
        planes.fold(point, |point, (_, axis, place)| {
            let rest = place - dot3(point, self.axes[axis]);
            add(point, scale(rest, self.axes[axis]))
        })
    }

    /// Each plane that there could be, its axis and its place along it.
    fn each(&self) -> [(OnPlanes, usize, f64); 6] {
        std::array::from_fn(|at| {
            let [axis, side] = [at / 2, at % 2];
            (if side == 0 { low(axis) } else { high(axis) }, axis, self.offsets[axis][side])
        })
    }

    /// The image of a displacement in a cell.
    pub fn turned(&self, displacement: Vector3, cell: Cell) -> Vector3 {
        let odd = cell.iter().zip(self.axes).filter(|(number, _)| *number & 1 != 0);
        odd.fold(displacement, |image, (_, axis)| {
            add(image, scale(-2.0 * dot3(displacement, axis), axis))
        })
    }
}

/// Three orthonormal axes that have these directions among them, in their order.
fn frame(normals: impl Iterator<Item = Vector3>) -> [Vector3; 3] {
    let mut axes: Vec<Vector3> = Vec::new();
    let ways = [0, 1, 2].map(|k| std::array::from_fn(|j| if j == k { 1.0 } else { 0.0 }));
    for direction in normals.chain(ways) {
        let rest = axes
            .iter()
            .fold(direction, |rest, &axis| add(rest, scale(-dot3(direction, axis), axis)));
        // Of three orthonormal directions one is at least so far off two others.
        if axes.len() < 3 && length(rest) > 0.5 {
            axes.extend(unit(rest));
        }
    }
    std::array::from_fn(|k| axes[k])
}

fn nearest(axes: &[Vector3; 3], direction: Vector3) -> usize {
    let along = axes.map(|axis| dot3(axis, direction).abs());
    (0..3).fold(0, |best, k| if along[k] > along[best] { k } else { best })
}

fn sum(points: &[Vector3]) -> Vector3 {
    points.iter().fold([0.0; 3], |sum, &point| add(sum, point))
}
