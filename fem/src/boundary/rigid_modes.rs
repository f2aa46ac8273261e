//! Whether constraints leave a body motions without deformation.

use crate::boundary::constraints::Constraints;
use crate::boundary::hinged_bodies::loose_body;
use crate::boundary::motions::{Hold, free_modes};
use crate::error::Error;
use octruss_base::disjoint_sets::DisjointSets;
use octruss_base::vector3::Vector3;
use octruss_mesh::{Bodies, TetMesh, Topology};

/// Checks that the constraints, and springs with a stiffness in these (tet, position,
/// direction), leave no part of the mesh a rigid motion, and no body of it one about hinges
/// on which it hangs.
pub(crate) fn check_rigid_modes(
    mesh: &TetMesh,
    topology: &Topology,
    constraints: &Constraints,
    springs: &[(u32, Vector3, Vector3)],
) -> Result<(), Error> {
    let bodies = Bodies::new(mesh.tets(), mesh.points().len(), topology.face_tets());
    let mut held: Vec<Vec<Hold>> = vec![Vec::new(); bodies.count()];
    for vertex in constraints.held() {
        let position = mesh.points()[vertex.vertex as usize];
        // Vertices that no tet uses hold nothing.
        for &body in bodies.at(vertex.vertex) {
            let holds = vertex.directions().map(|direction| (position, direction));
            held[body as usize].extend(holds);
        }
    }
    for &(tet, position, direction) in springs {
        held[bodies.of_tets()[tet as usize] as usize].push((position, direction));
    }
    for part in parts(&bodies) {
        let together: Vec<Hold>;
        let all = match part[..] {
            [body] => &held[body as usize],
            _ => {
                together = part.iter().flat_map(|&body| &held[body as usize]).copied().collect();
                &together
            }
        };
        let modes = free_modes(all, || mesh.points()[lowest_vertex(mesh, &bodies, &part)]);
        if !modes.is_empty() {
            let vertices = vertices_of(mesh, &bodies, &part);
            let (vertices, example) = (vertices.len(), vertices[0]);
            return Err(Error::RigidModes { vertices, example, modes });
        }
    }
    match loose_body(mesh.points(), &bodies, held) {
        None => Ok(()),
        Some((body, modes)) => {
            let vertices = vertices_of(mesh, &bodies, &[body]);
            let (vertices, example) = (vertices.len(), vertices[0]);
            Err(Error::Hinged { vertices, example, modes })
        }
    }
}

/// The bodies that hang together by whatever they have in common, ascending.
fn parts(bodies: &Bodies) -> Vec<Vec<u32>> {
    let mut sets = DisjointSets::new(bodies.count());
    for (_, meeting) in bodies.shared() {
        meeting[1..].iter().for_each(|&body| sets.join(meeting[0], body));
    }
    let mut members: Vec<(u32, u32)> =
        (0..bodies.count() as u32).map(|body| (sets.lowest(body), body)).collect();
    members.sort_unstable();
    let part = |same: &[(u32, u32)]| same.iter().map(|(_, body)| *body).collect();
    members.chunk_by(|a, b| a.0 == b.0).map(part).collect()
}

/// The vertices of some bodies (ascending), ascending.
fn vertices_of(mesh: &TetMesh, bodies: &Bodies, some: &[u32]) -> Vec<u32> {
    let is_one = |v: &u32| bodies.at(*v).iter().any(|body| some.binary_search(body).is_ok());
    (0..mesh.points().len() as u32).filter(is_one).collect()
}

fn lowest_vertex(mesh: &TetMesh, bodies: &Bodies, some: &[u32]) -> usize {
    vertices_of(mesh, bodies, some)[0] as usize
}
