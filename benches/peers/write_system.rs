//! A refined mesh, a problem on it, and everything that a solver needs, in files.

use crate::arrays;
use crate::system_files::{Description, Prolongation, array, write_matrix};
use anyhow::{Context, Result, bail};
use octruss_fem::{
    Discretisation, Elasticity, Held, Material, Options, Poisson, Support, Unknown, vector,
};
use octruss_mesh::shapes::kuhn_cube;
use octruss_mesh::{
    CheckOptions, FeatureOptions, Hierarchy, Scheme, TetMesh, check, prepare, sort_along_curve,
};
use octruss_solver::{Nodal, Transfer};
use std::fs;
use std::path::Path;
use std::time::Instant;

/// Refines a mesh by the box-spline scheme, which leaves the cube as it is, and
/// writes a problem on the finest level with linear and box-spline prolongations.
pub fn write(mesh: &str, problem: &str, levels: usize, folder: &Path) -> Result<()> {
    let features = FeatureOptions::default();
    let (mesh, _) = sort_along_curve(prepare(coarsest(mesh)?, &features));
    let mut hierarchy = Hierarchy::new(mesh, &features);
    for _ in 0..levels {
        hierarchy.subdivide(Scheme::BoxSpline)?;
    }
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    match problem {
        "poisson" => poisson(&hierarchy, folder),
        "elasticity" => elasticity(&hierarchy, folder),
        other => bail!("`{other}` is no problem: expected `poisson` or `elasticity`"),
    }
}

fn coarsest(name: &str) -> Result<TetMesh> {
    if let Some(cells) = name.strip_prefix("cube:") {
        return Ok(kuhn_cube(cells.parse().context("expected cube:N")?));
    }
    let dataset = octruss_meshio::read(name.as_ref())?;
    Ok(check(dataset.mesh, &CheckOptions::default())?.mesh)
}

/// −Δu = 1, u = 0 on all surfaces.
fn poisson(hierarchy: &Hierarchy, folder: &Path) -> Result<()> {
    let surfaces = hierarchy.finest().mesh.raw().ids(2);
    let fixed: Vec<_> = surfaces.into_iter().map(|surface| (surface, 0.0.into())).collect();
    let problem = Poisson { source: 1.0.into(), fixed, ..Poisson::default() };
    write_all(&Discretisation::new(hierarchy, &problem, &Options::default())?, folder)
}

/// E = 1, ν = 0.3, clamped at surface 1 (the side x = 0 of the cube, the bolts of the
/// bracket), pulled down by a force on its volume.
fn elasticity(hierarchy: &Hierarchy, folder: &Path) -> Result<()> {
    let problem = Elasticity {
        body_force: vector([0.0, 0.0, -1.0]).into(),
        supports: vec![Support { surface: 1, held: Held::displacement([0.0; 3]) }],
        ..Elasticity::new(Material::new(1.0, 0.3))
    };
    write_all(&Discretisation::new(hierarchy, &problem, &Options::default())?, folder)
}

fn write_all<E: Unknown>(system: &Discretisation<E>, folder: &Path) -> Result<()> {
    write_matrix(folder, "matrix", &system.matrix)?;
    arrays::write(&array(folder, "rhs"), Nodal::flat(&system.rhs).iter().copied())?;
    for (name, level, unknowns) in [
        ("points", system.hierarchy.finest(), system.finest()),
        ("coarsest-points", system.hierarchy.coarsest(), &system.levels[0]),
    ] {
        let free = unknowns.dofs.free().iter();
        let positions: Vec<_> = free.map(|&vertex| level.mesh.points()[vertex as usize]).collect();
        arrays::write(&array(folder, name), positions.as_flattened().iter().copied())?;
    }
    let prolongations = [Scheme::Linear, Scheme::BoxSpline]
        .map(|scheme| write_prolongations(system, scheme, folder))
        .into_iter()
        .collect::<Result<_>>()?;
    let rows = system.levels.iter().rev().map(|level| level.dofs.unknowns()).collect();
    let description = Description { block: E::SIZE, rows, prolongations };
    fs::write(folder.join("system.json"), serde_json::to_string_pretty(&description)?)?;
    Ok(())
}

/// Makes prolongations as a run does; writes them with the finest first.
fn write_prolongations<E: Unknown>(
    system: &Discretisation<E>,
    scheme: Scheme,
    folder: &Path,
) -> Result<Prolongation> {
    let start = Instant::now();
    let options = Options { prolongation: Some(scheme.into()), ..Options::default() };
    let transfers = system.transfers(&options)?;
    let seconds = start.elapsed().as_secs_f64();
    let summaries = system.transfer_summaries(&options);
    let affine_defect = summaries.iter().map(|summary| summary.affine_defect).fold(0.0, f64::max);
    for (number, Transfer { prolongation, .. }) in transfers.iter().rev().enumerate() {
        write_matrix(folder, &format!("{}.{number}", scheme.name()), prolongation)?;
    }
    Ok(Prolongation { name: scheme.name().into(), seconds, affine_defect })
}
