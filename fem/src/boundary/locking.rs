//! Where the shape of a surface that is held along its normals locks what should slide.

use crate::boundary::surface_normals::{SMOOTH, facets, vertex_normals};
use crate::error::Error;
use crate::problem::elasticity::Support;
use octruss_base::vector3::dot3;
use octruss_mesh::{TetMesh, Topology};

/// The cosine of 4°: borders of less are flat but for noise.
const BENT: f64 = 0.997_564_050_259_824;

/// The surfaces held along normals that are curved, ascending: where triangles that hold a
/// vertex together differ by more than noise.
///
/// Where linear refinement splits such a triangle, the new vertices inside it are held along
/// its own normal, its corners along others: the facet locks what should slide round.
///
/// # Errors
/// As for the constraints of these supports.
pub fn curved_supports(
    mesh: &TetMesh,
    topology: &Topology,
    supports: &[Support],
) -> Result<Vec<i32>, Error> {
    let normals = vertex_normals(&facets(mesh, topology, supports)?);
    let curved = normals.iter().filter(|normal| normal.is_curved);
    let mut surfaces: Vec<i32> = curved.map(|normal| supports[normal.support].surface).collect();
    surfaces.sort_unstable();
    surfaces.dedup();
    Ok(surfaces)
}

/// Two surfaces, both held along their normals, that meet at a bend which is smooth to these
/// supports but sharp to refinement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ridge {
    /// Their tags, ascending.
    pub surfaces: [i32; 2],
    /// The greatest angle between their normals there, between 4° and 40°.
    pub degrees: f64,
}

/// The ridges among supports on a mesh that was readied for refinement, ascending.
///
/// Smooth schemes round a surface off on both sides of a crease and leave the crease where it
/// is: it stands out of what it belongs to, and nothing slides past it.
///
/// # Errors
/// As for the constraints of these supports.
pub fn ridges(
    mesh: &TetMesh,
    topology: &Topology,
    supports: &[Support],
) -> Result<Vec<Ridge>, Error> {
    let Some(features) = mesh.features() else { return Ok(Vec::new()) };
    let facets = facets(mesh, topology, supports)?;
    let edges_of =
        |(facet, [a, b, c]): (usize, [u32; 3])| [[a, b], [a, c], [b, c]].map(|edge| (edge, facet));
    let mut edges: Vec<([u32; 2], usize)> =
        facets.iter().map(|facet| facet.vertices).enumerate().flat_map(edges_of).collect();
    edges.sort_unstable();
    let mut ridges: Vec<Ridge> = Vec::new();
    for pair in edges.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        let sides = [0, 1].map(|k| &facets[pair[k].1]);
        let cosine = dot3(sides[0].normal, sides[1].normal);
        let mut surfaces = sides.map(|facet| supports[facet.support].surface);
        surfaces.sort_unstable();
        let is_bent = cosine < BENT && cosine > SMOOTH && surfaces[0] != surfaces[1];
        if is_bent && features.creases.binary_search(&pair[0].0).is_ok() {
            ridges.push(Ridge { surfaces, degrees: cosine.acos().to_degrees() });
        }
    }
    ridges.sort_by(|a, b| a.surfaces.cmp(&b.surfaces).then(b.degrees.total_cmp(&a.degrees)));
    ridges.dedup_by_key(|ridge| ridge.surfaces);
    Ok(ridges)
}
