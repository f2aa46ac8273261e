//! Refines a coarse ball by the box-spline scheme and solves a Poisson problem
//! on it, with the refinement's own matrices as prolongations.
//!
//!     cargo run --release --example 01_heated_ball
//!
//! On a ball of radius R, −Δu = 6 with u = 0 on the surface has the solution
//! u = R² − r². The scheme keeps no sharp edge here and shrinks the ball a
//! little, so R is taken from the refined volume.

use octruss_fem::{Poisson, assemble, restrict_to_free};
use octruss_mesh::{CheckOptions, FeatureOptions, Hierarchy, Scheme, check};
use octruss_solver::{Multigrid, MultigridOptions, SolveOptions, conjugate_gradients};

/// The whole chain in five steps.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    // 1. Read and check.
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/meshes/ball.msh");
    let dataset = octruss_meshio::read(path.as_ref())?;
    let mesh = check(dataset.mesh, &CheckOptions::default())?.mesh;

    // 2. Refine three times; the matrix of each step moves the points.
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    for _ in 0..3 {
        hierarchy.subdivide(Scheme::BoxSpline)?;
    }

    // 3. The problem: u is fixed on the surface group called "surface".
    let problem = Poisson {
        source: 6.0.into(),
        fixed: hierarchy
            .coarsest()
            .mesh
            .raw()
            .group_ids(2, "surface")
            .into_iter()
            .map(|id| (id, 0.0.into()))
            .collect(),
        ..Poisson::default()
    };
    let levels = hierarchy.levels().iter();
    let systems = levels
        .map(|level| assemble(&level.mesh, &level.topology, &problem))
        .collect::<Result<Vec<_>, _>>()?;
    let finest = &systems[3];

    // 4. Multigrid from the same matrices, finest transfer first.
    let prolongations = (0..3)
        .rev()
        .map(|l| {
            restrict_to_free(
                &hierarchy.refinement(l).matrix,
                &systems[l + 1].dofs,
                &systems[l].dofs,
            )
        })
        .collect::<Result<_, _>>()?;
    let mut multigrid =
        Multigrid::new(&finest.matrix, prolongations, &MultigridOptions::default())?;
    println!("{multigrid}");
    let (x, report) =
        conjugate_gradients(&finest.matrix, &finest.rhs, &mut multigrid, &SolveOptions::default())?;

    // 5. Compare with the exact solution of the ball of the same volume.
    let temperature = finest.expand(&x)?;
    let highest = temperature.iter().copied().fold(0.0, f64::max);
    let ball = &hierarchy.finest().mesh;
    let volume: f64 = (0..ball.tets().len()).map(|tet| ball.volume(tet)).sum();
    let radius_squared = (3.0 * volume / (4.0 * std::f64::consts::PI)).cbrt().powi(2);
    println!(
        "{} tets, {} iterations; highest value {highest:.4}, R² = {radius_squared:.4}",
        ball.tets().len(),
        report.iterations
    );
    assert!(report.iterations <= 7);
    assert!((highest / radius_squared - 1.0).abs() < 0.01);
    Ok(())
}
