//! Loads a refined bracket and asks where it is stressed and what its bolts carry.
//!
//!     cargo run --release --example 03_loaded_bracket
//!
//! The same as `configs/bracket-elasticity.toml` does, in the library's own words,
//! with one material and one load.

use octruss_fem::{
    Discretisation, Elasticity, Forces, Held, Material, Options, Support, strains, stresses,
    von_mises,
};
use octruss_mesh::{CheckOptions, FeatureOptions, Hierarchy, Scheme, check};
use octruss_solver::Smoother;

/// The whole chain in five steps.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    // 1. Read, check, refine twice, with sharp edges kept.
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/meshes/bracket.msh");
    let mesh = check(octruss_meshio::read(path.as_ref())?.mesh, &CheckOptions::default())?.mesh;
    let features = FeatureOptions { crease_angle: 40.0, ..FeatureOptions::default() };
    let mut hierarchy = Hierarchy::new(mesh, &features);
    for _ in 0..2 {
        hierarchy.subdivide(Scheme::BoxSpline)?;
    }

    // 2. Steel in N and mm, clamped at the bolts, 40 N/mm² on top of the ribs.
    let surface = |name: &str| hierarchy.coarsest().mesh.raw().group_ids(2, name);
    let clamp = |surface| Support { surface, held: Held::displacement([0.0; 3]) };
    let problem = Elasticity {
        pressure: surface("load").into_iter().map(|id| (id, 40.0.into())).collect(),
        supports: surface("bolts").into_iter().map(clamp).collect(),
        ..Elasticity::new(Material::new(210e3, 0.3))
    };

    // 3. Multigrid from the matrices that refined the mesh. Chebyshev polynomials take
    //    fewer iterations than the default for elasticity, whose iterations cost less.
    let options = Options { smoother: Some(Smoother::CHEBYSHEV), ..Options::default() };
    let body = Discretisation::new(&hierarchy, &problem, &options)?;
    let mut solver = body.solver(&options)?;
    println!("{}", solver.multigrid);
    let solution = solver.solve(None)?;

    // 4. Stresses and forces.
    let (level, displacement) = (hierarchy.finest(), &solution.values);
    let stress = stresses(&level.mesh, &problem, &strains(&level.mesh, displacement)?)?;
    let greatest = stress.iter().map(von_mises).fold(0.0, f64::max);
    let finest = (&level.mesh, &level.topology);
    let forces = Forces::new(finest, &problem, &body.constraints, displacement, &stress)?;
    let lowest = displacement.iter().map(|u| u[2]).fold(0.0, f64::min);
    println!(
        "{} iterations; {lowest:.4} mm down, {greatest:.0} N/mm² at most, bolts carry {:.1} N",
        solution.report.iterations, forces.supports[0][2]
    );

    // 5. The load stands on flat faces of 423 mm²: 40 · 423 = 16,920 N.
    assert!(solution.report.iterations <= 12);
    assert!((forces.supports[0][2] - 16_920.0).abs() < 0.01);
    assert!(forces.imbalance() < 1e-7);
    Ok(())
}
