//! Parts of an elastic body that can move without deforming.

use crate::boundary::constraints::Constraints;
use crate::boundary::dofs::vertices_of_tets;
use crate::rigid_motion::RigidMotion;
use nalgebra::{Matrix6, SymmetricEigen};
use octruss_base::vector3::{Vector3, add, apply, length, scale, subtract};
use octruss_mesh::TetMesh;
use octruss_mesh::components::part_of_vertices;
use std::collections::BTreeMap;

/// Motions that change the held directions by less than this, relative to what a held motion
/// does, squared, count as free.
const FREE: f64 = 1e-12;

/// A part with the rigid motions that what holds it leaves.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FreePart {
    /// Its vertices, ascending.
    pub(crate) vertices: Vec<u32>,
    /// Independent motions, at most six.
    pub(crate) motions: Vec<RigidMotion>,
}

/// The parts that constraints, and springs with a stiffness in these (tet, position,
/// direction), leave rigid motions; by their first vertex.
pub(crate) fn free_parts(
    mesh: &TetMesh,
    constraints: &Constraints,
    springs: &[(u32, Vector3, Vector3)],
) -> Vec<FreePart> {
    let (parts, in_tet) = (part_of_vertices(mesh.raw()), vertices_of_tets(mesh));
    let mut held: BTreeMap<u32, Vec<(Vector3, Vector3)>> = BTreeMap::new();
    for vertex in constraints.held() {
        let position = mesh.points()[vertex.vertex as usize];
        let conditions = vertex.directions().map(|direction| (position, direction));
        held.entry(parts[vertex.vertex as usize]).or_default().extend(conditions);
    }
    for &(tet, position, direction) in springs {
        held.entry(parts[mesh.tets()[tet as usize][0] as usize])
            .or_default()
            .push((position, direction));
    }
    let mut members: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for vertex in (0..parts.len() as u32).filter(|v| in_tet[*v as usize]) {
        members.entry(parts[vertex as usize]).or_default().push(vertex);
    }
    let free = members.into_iter().map(|(part, vertices)| {
        let motions = free_motions(mesh, &vertices, held.get(&part).map_or(&[], Vec::as_slice));
        FreePart { vertices, motions }
    });
    free.filter(|part| !part.motions.is_empty()).collect()
}

/// The motions of some vertices that leave direction · u = 0 at all held positions.
fn free_motions(mesh: &TetMesh, vertices: &[u32], held: &[(Vector3, Vector3)]) -> Vec<RigidMotion> {
    let points = || vertices.iter().map(|&v| mesh.points()[v as usize]);
    let origin = mesh.points()[vertices[0] as usize];
    let arms = points().map(|point| subtract(point, origin));
    let centre = add(origin, scale(1.0 / vertices.len() as f64, arms.fold([0.0; 3], add)));
    let size = points().map(|point| length(subtract(point, centre))).fold(0.0, f64::max);
    let still = RigidMotion { centre, size, motion: [0.0; 6] };
    let gram = held.iter().fold(Matrix6::zeros(), |sum, (position, direction)| {
        let row = still.moment(*position, *direction);
        sum + row * row.transpose()
    });
    let eigen = SymmetricEigen::new(gram);
    let bound = FREE * eigen.eigenvalues.max();
    let free = (0..6).filter(|&k| eigen.eigenvalues[k] <= bound);
    free.map(|k| still.with(std::array::from_fn(|i| eigen.eigenvectors[(i, k)]))).collect()
}

impl FreePart {
    /// Its unknowns, and its motions as displacements of these.
    pub(crate) fn null_vectors(
        &self,
        mesh: &TetMesh,
        constraints: &Constraints,
    ) -> (Vec<u32>, Vec<Vec<Vector3>>) {
        let (dofs, held) = (constraints.dofs(), constraints.by_vertex());
        let with_unknown = || self.vertices.iter().filter(|v| dofs.unknown(**v).is_some());
        let displaced = |motion: &RigidMotion| {
            let of = |&vertex: &u32| {
                let moved = motion.at(mesh.points()[vertex as usize]);
                held.get(vertex).map_or(moved, |held| apply(&held.projector, moved))
            };
            with_unknown().map(of).collect()
        };
        let rows = with_unknown().filter_map(|v| dofs.unknown(*v)).collect();
        (rows, self.motions.iter().map(displaced).collect())
    }

    /// Conditions that hold a part of its own by themselves: all displacements of three
    /// corners of a tet, as (tet, position, direction).
    pub(crate) fn anchors(mesh: &TetMesh, tet: u32) -> Vec<(u32, Vector3, Vector3)> {
        let corners = &mesh.tets()[tet as usize][..3];
        let all = corners.iter().flat_map(|&vertex| {
            octruss_base::vector3::IDENTITY.map(|axis| (tet, mesh.points()[vertex as usize], axis))
        });
        all.collect()
    }
}
