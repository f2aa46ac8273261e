//! Surfaces that look like mirror planes.

use crate::core::incidence::Incidence;
use crate::core::mirrors::PlaneFit;
use crate::core::raw_mesh::{Features, RawMesh};
use crate::core::strata::surface_faces;
use crate::core::tet_mesh::TetMesh;
use crate::core::topology::Topology;
use crate::features::mirrors::check_group;
use octruss_base::vector3::{Vector3, add, cross, dot3, length, scale, subtract};

/// How far the surfaces at a mirror plane may be from perpendicular, in degrees: a facet
/// of a round surface is by half the angle between two.
const MOST_TILT: f64 = 20.0;

/// Facets that are nearer to perpendicular, in degrees, end there flat.
const FLAT: f64 = 0.05;

/// The tilt of a round surface grows in proportion to the distance from a plane that it
/// meets at a right angle. Facets that begin where those at the plane end are then tilted
/// more than twice as much; those of an inclined wall are not.
const LEAST_GROWTH: f64 = 2.0;

/// Facets begin at the plane if a vertex is so near to it, in parts of the distance of the
/// vertex whose facets are looked at.
const NEAR: f64 = 0.05;

/// The surface groups that are probably mirror planes, ascending; to be told, not to be
/// taken for granted.
///
/// They are flat and bound the mesh, which lies on one side. Every surface that meets one
/// is perpendicular to it, as far as facets can tell, and some are round there, so that a
/// mirror plane makes a difference. Each could be one of [`crate::Mirrors`] by itself; not
/// always all together.
pub fn mirror_candidates(mesh: &TetMesh) -> Vec<i32> {
    let mesh = mesh.raw();
    let groups = mesh.ids(2);
    if groups.is_empty() {
        return groups;
    }
    let topology = Topology::new(mesh);
    let surfaces = Surfaces::new(mesh, &topology);
    let is_candidate = |&group: &i32| {
        check_group(mesh, &topology, group).is_ok_and(|fit| surfaces.are_round_across(group, &fit))
    };
    groups.into_iter().filter(is_candidate).collect()
}

/// The surfaces of a mesh: its boundary and what is between regions.
struct Surfaces<'a> {
    mesh: &'a RawMesh,
    topology: &'a Topology,
    at_edges: Incidence,
    at_vertices: Incidence,
}

impl<'a> Surfaces<'a> {
    fn new(mesh: &'a RawMesh, topology: &'a Topology) -> Self {
        let is_surface = surface_faces(mesh, topology, &Features::default());
        let faces = || (0u32..).zip(&is_surface).filter(|(_, is)| **is).map(|(face, _)| face);
        let pairs = |of: &[[u32; 3]]| {
            faces().flat_map(|face| of[face as usize].map(|part| [part, face])).collect()
        };
        let at_edges = Incidence::new(pairs(topology.face_edges()));
        let at_vertices = Incidence::new(pairs(topology.faces()));
        Self { mesh, topology, at_edges, at_vertices }
    }

    /// Whether all surfaces that meet a flat group are perpendicular to it, and some round.
    fn are_round_across(&self, group: i32, plane: &PlaneFit) -> bool {
        let own = self.mesh.triangles.iter().filter(|&(_, tag)| tag == group);
        let mut own: Vec<u32> = own.filter_map(|(t, _)| self.topology.face_of(t)).collect();
        own.sort_unstable();
        let mut sums = [0.0; 2];
        for &face in &own {
            for edge in self.topology.face_edges()[face as usize] {
                let others = self.at_edges.of(edge).iter();
                for &other in others.filter(|other| own.binary_search(other).is_err()) {
                    let near = self.sine(self.normal(other), plane);
                    if near.abs() > MOST_TILT.to_radians().sin() {
                        return false;
                    }
                    if near.abs() > FLAT.to_radians().sin() {
                        let far = self.sine(self.normal_beyond(other, edge, plane), plane);
                        let weight = self.edge_length(edge) * near.signum();
                        sums = [sums[0] + weight * near, sums[1] + weight * far];
                    }
                }
            }
        }
        sums[0] > 0.0 && sums[1] >= LEAST_GROWTH * sums[0]
    }

    /// That of the angle by which a normal is off a plane that it should lie in.
    fn sine(&self, normal: Vector3, plane: &PlaneFit) -> f64 {
        match length(normal) {
            size if size > 0.0 => dot3(normal, plane.normal) / size,
            _ => 0.0,
        }
    }

    /// The normal of a face, as long as twice its area.
    fn normal(&self, face: u32) -> Vector3 {
        let [a, b, c] = self.topology.faces()[face as usize].map(|v| self.mesh.points[v as usize]);
        cross(subtract(b, a), subtract(c, a))
    }

    /// The mean normal of the facets that go on smoothly behind one at the plane, which has
    /// an edge there; 0 if there are none.
    fn normal_beyond(&self, face: u32, edge: u32, plane: &PlaneFit) -> Vector3 {
        let (ends, own) = (self.topology.edges()[edge as usize], self.normal(face));
        let far = self.topology.faces()[face as usize].into_iter().find(|v| !ends.contains(v));
        let Some(far) = far else { return [0.0; 3] };
        let height = |v: u32| plane.height(self.mesh.points[v as usize]).abs();
        let is_beyond = |face: u32| {
            let vertices = self.topology.faces()[face as usize];
            vertices.iter().all(|&v| height(v) > NEAR * height(far))
        };
        let beyond = self.at_vertices.of(far).iter().filter(|&&face| is_beyond(face));
        let aligned = beyond.map(|&other| {
            let normal = self.normal(other);
            if dot3(normal, own) < 0.0 { scale(-1.0, normal) } else { normal }
        });
        let smooth = (2.0 * MOST_TILT).to_radians().cos();
        let is_smooth = |n: &Vector3| dot3(*n, own) >= smooth * length(*n) * length(own);
        aligned.filter(is_smooth).fold([0.0; 3], add)
    }

    fn edge_length(&self, edge: u32) -> f64 {
        let [a, b] = self.topology.edges()[edge as usize].map(|v| self.mesh.points[v as usize]);
        length(subtract(b, a))
    }
}
