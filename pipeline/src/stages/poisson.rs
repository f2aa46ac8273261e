//! A Poisson problem from the names that a config uses.

use octruss_mesh::RawMesh;
use octruss_solver::{ByRegion, Poisson, Scalar};

use super::Context;
use super::groups::group_ids;
use super::solve::{OnSurface, Solve};
use crate::error::Error;
use crate::recipe::{PerRegion, Value};

/// The problem that a stage describes, on this mesh.
///
/// # Errors
/// A surface or region that the mesh does not have.
pub fn poisson(options: &Solve, mesh: &RawMesh, context: &Context) -> Result<Poisson, Error> {
    Ok(Poisson {
        coefficient: by_region(&options.coefficient, 1.0, mesh, context)?,
        source: by_region(&options.source, 0.0, mesh, context)?,
        fixed: on_surfaces(&options.fixed, mesh, context)?,
        flux: on_surfaces(&options.flux, mesh, context)?,
    })
}

fn by_region(
    given: &PerRegion,
    otherwise: f64,
    mesh: &RawMesh,
    context: &Context,
) -> Result<ByRegion, Error> {
    let named = match given {
        PerRegion::Uniform(Value(number)) => return Ok(ByRegion::from(*number)),
        PerRegion::Named(named) => named,
    };
    let (mut default, mut regions) = (otherwise, Vec::new());
    for (name, Value(number)) in named {
        if name.get_ref() != PerRegion::DEFAULT {
            let ids = group_ids(mesh, 3, name, context)?;
            regions.extend(ids.into_iter().map(|id| (id, Scalar::from(*number))));
        } else if mesh.group_ids(3, PerRegion::DEFAULT).is_empty() {
            default = *number;
        } else {
            let message = "`default` stands for all regions that are not named, but a region of \
                the mesh is called so, too: rename that region, or name all others instead";
            return Err(context.name_error(name, message));
        }
    }
    Ok(ByRegion { default: default.into(), regions })
}

fn on_surfaces(
    given: &[OnSurface],
    mesh: &RawMesh,
    context: &Context,
) -> Result<Vec<(i32, Scalar)>, Error> {
    let mut surfaces = Vec::new();
    for OnSurface { surface, value } in given {
        let ids = group_ids(mesh, 2, surface, context)?;
        surfaces.extend(ids.into_iter().map(|id| (id, Scalar::from(value.0))));
    }
    Ok(surfaces)
}
