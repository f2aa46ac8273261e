//! A Poisson problem from the names that a config uses.

use octruss_mesh::RawMesh;
use octruss_solver::{ByRegion, Poisson, Scalar};

use super::groups::group_ids;
use super::solve::{OnSurface, Solve};
use crate::recipe::{PerRegion, Value};

/// The problem that a stage describes, on this mesh.
///
/// # Errors
/// A surface or region that the mesh does not have.
pub fn poisson(options: &Solve, mesh: &RawMesh) -> Result<Poisson, String> {
    Ok(Poisson {
        coefficient: by_region(&options.coefficient, 1.0, mesh)?,
        source: by_region(&options.source, 0.0, mesh)?,
        fixed: on_surfaces(&options.fixed, mesh)?,
        flux: on_surfaces(&options.flux, mesh)?,
    })
}

fn by_region(given: &PerRegion, otherwise: f64, mesh: &RawMesh) -> Result<ByRegion, String> {
    let mut regions = Vec::new();
    for (name, &Value(number)) in &given.named {
        let ids = group_ids(mesh, 3, name)?;
        regions.extend(ids.into_iter().map(|id| (id, Scalar::from(number))));
    }
    let default = given.default.map_or(otherwise, |Value(number)| number);
    Ok(ByRegion { default: default.into(), regions })
}

fn on_surfaces(given: &[OnSurface], mesh: &RawMesh) -> Result<Vec<(i32, Scalar)>, String> {
    let mut surfaces = Vec::new();
    for OnSurface { surface, value } in given {
        let ids = group_ids(mesh, 2, surface)?;
        surfaces.extend(ids.into_iter().map(|id| (id, Scalar::from(value.0))));
    }
    Ok(surfaces)
}
