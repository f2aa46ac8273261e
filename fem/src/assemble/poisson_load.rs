//! What acts on a Poisson problem from outside: sources, fluxes, exchange.

use crate::assemble::blame;
use crate::assemble::foundation::Foundation;
use crate::assemble::load::{add_at, tet_load, triangle_load};
use crate::assemble::scatter::{Scatter, Sums};
use crate::boundary::surface::{check_attached, triangles_of};
use crate::error::Error;
use crate::problem::poisson::{Poisson, Robin};
use crate::problem::scalar::Scalar;
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::check_finite;
use std::cell::Cell;
use std::slice::from_ref;

/// ∫ f φ for each vertex.
pub(crate) fn source_vector(mesh: &TetMesh, problem: &Poisson) -> Result<Vec<f64>, Error> {
    problem.source.check(mesh)?;
    let vertices = mesh.points().len();
    let Some(load) = source_load(mesh, problem) else { return Ok(vec![0.0; vertices]) };
    Ok(Scatter::new(mesh.tets(), vertices).sum(load).in_order().into_flattened())
}

/// ∫ f φ over a tet for its corners, unless f is 0.
pub(crate) fn source_load(
    mesh: &TetMesh,
    problem: &Poisson,
) -> Option<impl Fn(usize) -> [[f64; 1]; 4]> {
    let load = |tet: usize| {
        let source = problem.source.of(mesh.regions()[tet]);
        tet_load(mesh.corners(tet), source.is_constant(), |p| [source.at(p)])
    };
    (!problem.source.all(Scalar::is_zero)).then_some(load)
}

/// Adds ∫ g φ + ∫ c (u₀ − r) φ over surfaces, with the reference r of each vertex, which is
/// the same all over a part; 0 if not given.
pub(crate) fn add_surface_load(
    mesh: &TetMesh,
    topology: &Topology,
    problem: &Poisson,
    reference: Option<&[f64]>,
    load: &mut [[f64; 1]],
) -> Result<(), Error> {
    let mut add = |surface: i32, is_constant: bool, flux: &dyn Fn([f64; 3], f64) -> f64| {
        check_attached(mesh, topology, surface)?;
        for triangle in triangles_of(mesh, surface) {
            let corners = triangle.map(|v| mesh.points()[v as usize]);
            let reference = reference.map_or(0.0, |all| all[triangle[0] as usize]);
            add_at(load, triangle, triangle_load(corners, is_constant, |p| [flux(p, reference)]));
        }
        Ok::<_, Error>(())
    };
    for (surface, flux) in &problem.flux {
        add(*surface, flux.is_constant(), &|p, _| flux.at(p))?;
    }
    for (surface, Robin { coefficient, value }) in &problem.robin {
        let is_constant = coefficient.is_constant() && value.is_constant();
        add(*surface, is_constant, &|p, r| coefficient.at(p) * (value.at(p) - r))?;
    }
    Ok(())
}

/// The values of surroundings at the vertices that exchange with them.
pub(crate) fn surrounding_values(mesh: &TetMesh, problem: &Poisson) -> Vec<(u32, f64)> {
    let mut values = Vec::new();
    for (surface, Robin { coefficient, value }) in &problem.robin {
        for vertex in triangles_of(mesh, *surface).flatten() {
            let position = mesh.points()[vertex as usize];
            if coefficient.at(position) > 0.0 {
                values.push((vertex, value.at(position)));
            }
        }
    }
    values
}

/// Checks that a right-hand side is finite; if not, says which datum is to blame.
pub(crate) fn check_load(mesh: &TetMesh, problem: &Poisson, rhs: &[f64]) -> Result<(), Error> {
    check_finite("load vector", rhs)
        .map_err(|error| blame_load(mesh, problem).err().unwrap_or(error.into()))
}

/// Which source, flux or surrounding value is not finite.
fn blame_load(mesh: &TetMesh, problem: &Poisson) -> Result<(), Error> {
    blame::in_tets(mesh, "source", |region| from_ref(problem.source.of(region)))?;
    for (surface, flux) in &problem.flux {
        blame::on_surface(mesh, "flux", *surface, from_ref(flux))?;
    }
    for (surface, robin) in &problem.robin {
        blame::on_surface(mesh, "Robin value", *surface, from_ref(&robin.value))?;
    }
    Ok(())
}

/// Adds ∫ c φa φb to the couplings; returns the row sums ∫ c φa.
pub(crate) fn add_robin(
    mesh: &TetMesh,
    topology: &Topology,
    robin: &[(i32, Robin)],
    couplings: &mut Sums<1>,
) -> Result<Vec<[f64; 1]>, Error> {
    let mut foundation = Foundation::new(topology, couplings);
    for (surface, Robin { coefficient, .. }) in robin {
        check_attached(mesh, topology, *surface)?;
        let first_bad = Cell::new(None);
        let c = |position: [f64; 3]| {
            let c = coefficient.at(position);
            if !(c >= 0.0 && c.is_finite()) && first_bad.get().is_none() {
                first_bad.set(Some(position));
            }
            [c]
        };
        for triangle in triangles_of(mesh, *surface) {
            foundation.add(triangle, triangle.map(|v| mesh.points()[v as usize]), c);
        }
        if let Some(position) = first_bad.get() {
            return Err(Error::SurfaceCoefficient {
                what: "Robin coefficient",
                surface: *surface,
                told: coefficient.told_at(position),
                expected: "0 or more",
            });
        }
    }
    Ok(foundation.into_row_sums())
}
