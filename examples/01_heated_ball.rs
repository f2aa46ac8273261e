//! Refines a coarse ball by the box-spline scheme and solves a Poisson problem
//! on it, with the refinement's own matrices as prolongations.
//!
//!     cargo run --release --example 01_heated_ball
//!
//! On a ball of radius R, −Δu = 6 with u = 0 on the surface has the solution
//! u = R² − r². The scheme keeps no sharp edge here and shrinks the ball a
//! little, so R is taken from the refined volume.

use octruss_fem::{Discretisation, Options, Poisson};
use octruss_mesh::{CheckOptions, FeatureOptions, Hierarchy, Scheme, check};

/// The whole chain in four steps.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    // 1. Read and check.
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/meshes/ball.msh");
    let mesh = check(octruss_meshio::read(path.as_ref())?.mesh, &CheckOptions::default())?.mesh;
    let surface = mesh.raw().group_ids(2, "surface");

    // 2. Refine three times; the matrix of each step moves the points.
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    for _ in 0..3 {
        hierarchy.subdivide(Scheme::BoxSpline)?;
    }

    // 3. Solve −Δu = 6 with u = 0 on the surface.
    let fixed = surface.into_iter().map(|id| (id, 0.0.into())).collect();
    let problem = Poisson { source: 6.0.into(), fixed, ..Poisson::default() };
    let options = Options::default();
    let solution = Discretisation::new(&hierarchy, &problem, &options)?.solve(&options)?;

    // 4. Compare with the exact solution of the ball of the same volume.
    let highest = solution.values.iter().copied().fold(0.0, f64::max);
    let ball = &hierarchy.finest().mesh;
    let volume: f64 = (0..ball.tets().len()).map(|tet| ball.volume(tet)).sum();
    let radius_squared = (3.0 * volume / (4.0 * std::f64::consts::PI)).cbrt().powi(2);
    println!(
        "{} tets, {} iterations; highest value {highest:.4}, R² = {radius_squared:.4}",
        ball.tets().len(),
        solution.report.iterations
    );
    assert!(solution.report.iterations <= 7);
    assert!((highest / radius_squared - 1.0).abs() < 0.01);
    Ok(())
}
