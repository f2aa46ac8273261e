//! Mirror planes that are asked for.

use crate::core::mirrors::{PlaneFit, Planes};
use crate::core::raw_mesh::RawMesh;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::features::mirror_error::MirrorError;
use octruss_base::vector3::{Vector3, cross, dot3, length, subtract};

/// How far vertices may be off a mirror plane, against the size of the mesh; also the sine
/// by which planes may fail to be perpendicular.
const SMALL: f64 = 1e-6;

/// How far triangles may be inclined to a mirror plane, in degrees.
const MOST_DEGREES: f64 = 1.0;

/// Planar surface groups of a coarsest mesh that are mirror planes: the mesh is a half, a
/// quarter or an eighth of a body, and is refined as that part of it.
///
/// Surfaces and curves that end at such a plane go on behind it as if reflected, for
/// positions, limits, control points and fields alike. The planes themselves are no
/// surfaces, and their rims no creases, unless the body is sharp there: where a surface
/// meets its reflection at an angle above that of creases.
///
/// ```
/// use octruss_mesh::{FeatureOptions, Hierarchy, Mirrors, Scheme, shapes};
/// // An eighth of a box whose edges are smooth; surfaces 1, 3, 5 are x = 0, y = 0, z = 0.
/// let mesh = shapes::kuhn_cube(2);
/// let mirrors = Mirrors::new(&mesh, &[1, 3, 5])?;
/// let options = FeatureOptions { mirrors, crease_angle: 180.0, ..Default::default() };
/// let mut levels = Hierarchy::new(mesh, &options);
/// levels.subdivide(Scheme::BoxSpline)?;
/// // The middle of the box stays, as do the middles of its faces but for their own axis.
/// assert_eq!(levels.finest().mesh.points()[0], [0.0; 3]);
/// assert_eq!(levels.finest().mesh.points()[2][1..], [0.0; 2]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Mirrors {
    groups: Vec<i32>,
}

impl Mirrors {
    /// Checks surface groups, by their ids, of the mesh that is to be readied with them.
    ///
    /// # Errors
    /// If one has no triangles or is not flat and on the boundary, if the mesh is on both
    /// sides of a plane, if two planes are neither perpendicular nor parallel, or if other
    /// parts of the boundary lie in a plane with all their vertices on its rim.
    pub fn new(mesh: &TetMesh, groups: &[i32]) -> Result<Self, MirrorError> {
        let mut groups = groups.to_vec();
        groups.sort_unstable();
        groups.dedup();
        if groups.is_empty() {
            return Ok(Self::default());
        }
        let mesh = mesh.raw();
        let topology = Topology::new(mesh);
        let mut fits: Vec<PlaneFit> = Vec::new();
        for &group in &groups {
            let fit = check_group(mesh, &topology, group)?;
            for (other, &of) in fits.iter().zip(&groups) {
                check_angle(mesh, [(of, other), (group, &fit)])?;
            }
            fits.push(fit);
        }
        check_gaps(mesh, &topology, &groups)?;
        Ok(Self { groups })
    }

    /// The ids of the groups, ascending.
    pub fn groups(&self) -> &[i32] {
        &self.groups
    }
}

/// The plane of a group that is flat, on the boundary, and has the mesh on one side.
pub(super) fn check_group(
    mesh: &RawMesh,
    topology: &Topology,
    group: i32,
) -> Result<PlaneFit, MirrorError> {
    let allowed = SMALL * size(&mesh.points);
    let name = mesh.group_name(2, group);
    let fit = PlaneFit::new(mesh, group);
    let fit = fit.ok_or(MirrorError::NoTriangles { group: name.clone() })?;
    let side = Side { mesh, group, name, fit };
    side.check_boundary(topology)?;
    side.check_flat(allowed)?;
    side.check_front(allowed)?;
    Ok(fit)
}

/// The diagonal of the box round some points.
fn size(points: &[Vector3]) -> f64 {
    let fold = |by: fn(f64, f64) -> f64, start: f64| {
        points.iter().fold([start; 3], |all, p| std::array::from_fn(|k| by(all[k], p[k])))
    };
    length(subtract(fold(f64::max, f64::NEG_INFINITY), fold(f64::min, f64::INFINITY)))
}

/// A group with the plane nearest to it.
struct Side<'a> {
    mesh: &'a RawMesh,
    group: i32,
    name: String,
    fit: PlaneFit,
}

impl Side<'_> {
    fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        let own = self.mesh.triangles.iter().filter(|&(_, tag)| tag == self.group);
        own.map(|(triangle, _)| triangle)
    }

    fn check_boundary(&self, topology: &Topology) -> Result<(), MirrorError> {
        let is_inner = |triangle: &[u32; 3]| {
            topology.face_of(*triangle).is_none_or(|face| !topology.is_boundary(face as usize))
        };
        match self.triangles().filter(is_inner).count() {
            0 => Ok(()),
            count => Err(MirrorError::NotOnBoundary { group: self.name.clone(), count }),
        }
    }

    fn check_flat(&self, allowed: f64) -> Result<(), MirrorError> {
        let (mut distance, mut sine) = (0.0_f64, 0.0_f64);
        for triangle in self.triangles() {
            let [a, b, c] = triangle.map(|v| self.mesh.points[v as usize]);
            distance =
                [a, b, c].map(|p| self.fit.height(p).abs()).into_iter().fold(distance, f64::max);
            let normal = cross(subtract(b, a), subtract(c, a));
            sine = sine.max(length(cross(normal, self.fit.normal)) / length(normal));
        }
        let degrees = sine.min(1.0).asin().to_degrees();
        if distance <= allowed && degrees <= MOST_DEGREES {
            return Ok(());
        }
        Err(MirrorError::NotFlat { group: self.name.clone(), distance, degrees, allowed })
    }

    /// The mesh lies in front of the plane, which is the side of its middle.
    fn check_front(&self, allowed: f64) -> Result<(), MirrorError> {
        let heights = || self.mesh.points.iter().map(|&point| self.fit.height(point));
        let front = if heights().sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        let behind = || heights().map(|height| -front * height).filter(|depth| *depth > allowed);
        match behind().count() {
            0 => Ok(()),
            count => Err(MirrorError::Behind {
                group: self.name.clone(),
                count,
                distance: behind().fold(0.0, f64::max),
            }),
        }
    }
}

fn check_angle(mesh: &RawMesh, sides: [(i32, &PlaneFit); 2]) -> Result<(), MirrorError> {
    let [one, other] = sides.map(|(_, fit)| fit.normal);
    let (cosine, sine) = (dot3(one, other).abs(), length(cross(one, other)));
    if cosine <= SMALL || sine <= SMALL {
        return Ok(());
    }
    let groups = sides.map(|(group, _)| mesh.group_name(2, group));
    Err(MirrorError::Oblique { groups, degrees: sine.atan2(cosine).to_degrees() })
}

/// What has all its vertices on a plane is in its groups: it would else be its own image.
fn check_gaps(mesh: &RawMesh, topology: &Topology, groups: &[i32]) -> Result<(), MirrorError> {
    let Some(planes) = Planes::of(mesh, groups) else { return Ok(()) };
    let on = planes.at_vertices(mesh, topology.vertex_count());
    let mut is_mirror = vec![false; topology.faces().len()];
    let mut is_edge_of_mirror = vec![false; topology.edges().len()];
    let mirrors = mesh.triangles.iter().filter(|(_, tag)| groups.binary_search(tag).is_ok());
    for face in mirrors.filter_map(|(triangle, _)| topology.face_of(triangle)) {
        is_mirror[face as usize] = true;
        topology.face_edges()[face as usize]
            .iter()
            .for_each(|&e| is_edge_of_mirror[e as usize] = true);
    }
    let is_on_one =
        |vertices: &[u32]| vertices.iter().fold(u8::MAX, |all, &v| all & on[v as usize]) != 0;
    let edges = topology.edges().iter().zip(is_edge_of_mirror);
    let edges = edges.filter(|(ends, is_of_mirror)| !is_of_mirror && is_on_one(&ends[..]));
    let faces = topology.faces().iter().zip(is_mirror);
    let faces = faces.filter(|(face, is_mirror)| !is_mirror && is_on_one(&face[..]));
    let gaps = edges.map(|(ends, _)| *ends).chain(faces.map(|(face, _)| [face[0], face[1]]));
    let gaps: Vec<[u32; 2]> = gaps.collect();
    match *gaps {
        [] => Ok(()),
        [[a, b], ..] => Err(MirrorError::Gap { count: gaps.len(), a, b }),
    }
}
