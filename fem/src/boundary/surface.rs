//! The triangles of a surface that lie on tets.

use crate::error::Error;
use octruss_base::chunks::map_ranges;
use octruss_base::vector3::{cross, dot3, subtract};
use octruss_mesh::topology::NONE;
use octruss_mesh::{TetMesh, Topology};

/// A triangle of the boundary, seen from outside.
pub(crate) struct OutwardTriangle {
    pub(crate) vertices: [u32; 3],
    /// The outward normal, as long as twice the area.
    pub(crate) double_area: [f64; 3],
}

/// A triangle, and the tets on it.
type OnTets = ([u32; 3], [u32; 2]);

/// Checks that a surface id is in use.
pub(crate) fn check_surface(mesh: &TetMesh, id: i32) -> Result<(), Error> {
    if mesh.triangles().tags.contains(&id) {
        Ok(())
    } else {
        Err(Error::UnknownSurface { id, known: mesh.triangles().ids() })
    }
}

/// The triangles of a surface, as they stand.
pub(crate) fn triangles_of(mesh: &TetMesh, surface: i32) -> impl Iterator<Item = [u32; 3]> {
    mesh.triangles().iter().filter(move |(_, id)| *id == surface).map(|(triangle, _)| triangle)
}

/// Checks that a surface is in use and consists of faces of tets: what is given
/// elsewhere is lost.
pub(crate) fn check_attached(
    mesh: &TetMesh,
    topology: &Topology,
    surface: i32,
) -> Result<(), Error> {
    attached_triangles(mesh, topology, surface).map(drop)
}

/// The triangles of a surface with the tets on each; errors as [`check_attached`].
fn attached_triangles(
    mesh: &TetMesh,
    topology: &Topology,
    surface: i32,
) -> Result<Vec<OnTets>, Error> {
    check_surface(mesh, surface)?;
    let triangles: Vec<[u32; 3]> = triangles_of(mesh, surface).collect();
    let with_tets = |at: usize| (triangles[at], face_tets(topology, triangles[at]));
    let all = map_ranges(triangles.len(), |range| range.map(with_tets).collect::<Vec<_>>());
    let all = all.concat();
    let detached = all.iter().filter(|(_, [first, _])| *first == NONE).count();
    if detached == 0 { Ok(all) } else { Err(Error::DetachedSurface { id: surface, detached }) }
}

/// The triangles of a surface of the boundary, turned outward.
///
/// # Errors
/// Besides those of [`check_attached`], [`Error::InnerSurface`] where a triangle
/// has tets on both sides.
pub(crate) fn outward_triangles(
    mesh: &TetMesh,
    topology: &Topology,
    surface: i32,
) -> Result<Vec<OutwardTriangle>, Error> {
    let triangles = attached_triangles(mesh, topology, surface)?;
    let inner = triangles.iter().filter(|(_, [_, second])| *second != NONE).count();
    if inner > 0 {
        return Err(Error::InnerSurface { id: surface, inner });
    }
    let outward = |(vertices, [tet, _]): OnTets| {
        let tet = mesh.tets()[tet as usize];
        let [a, b, c] = vertices.map(|v| mesh.points()[v as usize]);
        let normal = cross(subtract(b, a), subtract(c, a));
        let inside = tet.into_iter().find(|v| !vertices.contains(v)).unwrap_or(tet[0]);
        let inward = subtract(mesh.points()[inside as usize], a);
        if dot3(normal, inward) > 0.0 {
            let [a, b, c] = vertices;
            OutwardTriangle { vertices: [a, c, b], double_area: normal.map(|x| -x) }
        } else {
            OutwardTriangle { vertices, double_area: normal }
        }
    };
    Ok(triangles.into_iter().map(outward).collect())
}

/// The first tet on a triangle; [`NONE`] where there is none.
pub(crate) fn tet_of(topology: &Topology, triangle: [u32; 3]) -> u32 {
    face_tets(topology, triangle)[0]
}

fn face_tets(topology: &Topology, triangle: [u32; 3]) -> [u32; 2] {
    let face = topology.face_of(triangle);
    face.map_or([NONE; 2], |face| topology.face_tets()[face as usize])
}
