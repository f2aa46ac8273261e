//! Which datum is at fault, once a sum over all of them is not finite.

use crate::boundary::surface::triangles_of;
use crate::element::quadrature::{DEGREE_2, TRIANGLE_DEGREE_2, position};
use crate::error::Error;
use crate::problem::scalar::Scalar;
use octruss_mesh::TetMesh;

/// The first tet in which one of its region's scalars is not finite.
pub(crate) fn in_tets<'a>(
    mesh: &TetMesh,
    what: &'static str,
    scalars: impl Fn(i32) -> &'a [Scalar],
) -> Result<(), Error> {
    for (tet, &region) in mesh.regions().iter().enumerate() {
        let corners = mesh.corners(tet);
        let points = DEGREE_2.iter().map(|(point, _)| position(&corners, point));
        check(what, points, scalars(region), || format!("region {region}"))?;
    }
    Ok(())
}

/// The first triangle of a surface on which one of the scalars is not finite.
pub(crate) fn on_surface(
    mesh: &TetMesh,
    what: &'static str,
    surface: i32,
    scalars: &[Scalar],
) -> Result<(), Error> {
    for triangle in triangles_of(mesh, surface) {
        let corners = triangle.map(|v| mesh.points()[v as usize]);
        let points = TRIANGLE_DEGREE_2.iter().map(|(point, _)| position(&corners, point));
        check(what, points, scalars, || format!("surface {surface}"))?;
    }
    Ok(())
}

fn check(
    what: &'static str,
    points: impl Iterator<Item = [f64; 3]>,
    scalars: &[Scalar],
    place: impl Fn() -> String,
) -> Result<(), Error> {
    for point in points {
        if let Some(bad) = scalars.iter().find(|scalar| !scalar.at(point).is_finite()) {
            return Err(Error::Load { what, place: place(), told: bad.told_at(point) });
        }
    }
    Ok(())
}
