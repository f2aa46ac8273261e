//! The load vector of sources and fluxes.
//!
//! Constants are integrated exactly; functions by rules of degree 2 (four
//! points a tet, three a triangle), which leaves an L² rate of 2 intact.

use crate::element::triangle_area;
use crate::error::Error;
use crate::problem::{ByRegion, Poisson, Scalar, check_surface};
use crate::quadrature::{DEGREE_2, TRIANGLE_DEGREE_2, position};
use crate::scatter::Scatter;
use octruss_mesh::topology::NONE;
use octruss_mesh::{TetMesh, Topology};

/// ∫ f φ + ∫ g φ over body and surfaces, for each vertex.
pub(crate) fn load_vector(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Poisson,
) -> Result<Vec<f64>, Error> {
    problem.source.check(mesh)?;
    let mut load = if is_zero(&problem.source) {
        vec![0.0; mesh.points().len()]
    } else {
        Scatter::new(mesh.tets(), mesh.points().len()).sum(|tet| {
            let source = problem.source.of(mesh.regions()[tet]);
            source_load(mesh.corners(tet), mesh.volume(tet), source)
        })
    };
    for (surface, flux) in &problem.flux {
        check_surface(mesh, *surface)?;
        check_attached(mesh, topology, *surface)?;
        for (triangle, _) in mesh.triangles().iter().filter(|(_, id)| id == surface) {
            let values = flux_load(triangle.map(|v| mesh.points()[v as usize]), flux);
            for (vertex, value) in triangle.into_iter().zip(values) {
                load[vertex as usize] += value;
            }
        }
    }
    Ok(load)
}

/// Checks that a surface consists of faces of tets: loads elsewhere are lost.
fn check_attached(mesh: &TetMesh, topology: &Topology, surface: i32) -> Result<(), Error> {
    let is_face = |triangle: [u32; 3]| {
        let face = topology.face_of(triangle);
        face.is_some_and(|face| topology.face_tets()[face as usize][0] != NONE)
    };
    let detached = mesh
        .triangles()
        .iter()
        .filter(|&(triangle, id)| id == surface && !is_face(triangle))
        .count();
    if detached == 0 { Ok(()) } else { Err(Error::DetachedSurface { id: surface, detached }) }
}

fn is_zero(source: &ByRegion) -> bool {
    let zero = |value: &Scalar| matches!(value, Scalar::Constant(0.0));
    zero(&source.default) && source.regions.iter().all(|(_, value)| zero(value))
}

fn source_load(corners: [[f64; 3]; 4], volume: f64, source: &Scalar) -> [f64; 4] {
    match source {
        Scalar::Constant(value) => [0.25 * volume * value; 4],
        Scalar::Function(f) => {
            let mut load = [0.0; 4];
            for (point, weight) in DEGREE_2 {
                let value = weight * volume * f(position(&corners, point));
                (0..4).for_each(|i| load[i] += value * point[i]);
            }
            load
        }
    }
}

fn flux_load(corners: [[f64; 3]; 3], flux: &Scalar) -> [f64; 3] {
    let area = triangle_area(corners);
    match flux {
        Scalar::Constant(value) => [area * value / 3.0; 3],
        Scalar::Function(f) => {
            let mut load = [0.0; 3];
            for (point, weight) in TRIANGLE_DEGREE_2 {
                let value = weight * area * f(position(&corners, point));
                (0..3).for_each(|i| load[i] += value * point[i]);
            }
            load
        }
    }
}
