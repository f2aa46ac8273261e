//! Problems on hierarchies whose last levels are finer at a corner only.

use octruss_fem::{Cycle, Discretisation, FullTransfer, Options, Poisson, assemble};
use octruss_mesh::shapes::kuhn_cube;
use octruss_mesh::{Diagonal, FeatureOptions, Hierarchy, MarkedEdges, Scheme};
use octruss_solver::{Multigrid, SolveOptions, conjugate_gradients};

/// A uniform step of some scheme, then local ones round the origin.
fn hierarchy(rounds: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(kuhn_cube(3), &FeatureOptions::default());
    hierarchy.subdivide(Scheme::BoxSpline).unwrap();
    for _ in 0..rounds {
        let topology = &hierarchy.finest().topology;
        let mut marks = MarkedEdges::new(topology);
        marks.mark_vertices(topology, [0]);
        hierarchy.split_red_green(&marks, Diagonal::Inherit).unwrap();
    }
    hierarchy
}

/// −Δu = 1, u = 2 on the side x = 1; the refined corner is free.
fn problem() -> Poisson {
    Poisson { source: 1.0.into(), fixed: vec![(2, 2.0.into())], ..Poisson::default() }
}

#[test]
fn whatever_prolongs_the_solution_is_that_of_the_direct_solver() {
    let (hierarchy, problem) = (hierarchy(4), problem());
    let finest = hierarchy.finest();
    let system = assemble(&finest.mesh, &finest.topology, &problem).unwrap();
    let mut direct = Multigrid::new(&system.matrix, vec![], &Default::default()).unwrap();
    let goal = SolveOptions { tolerance: 1e-13, ..SolveOptions::default() };
    let exact = conjugate_gradients(&system.matrix, &system.rhs, &mut direct, &goal).unwrap().0;
    let exact = system.expand(&exact).unwrap();
    let full = Options { cycle: Some(Cycle::Full), ..Options::default() };
    for options in [
        Options::default(),
        Options { prolongation: Some(Scheme::BoxSpline.into()), ..Options::default() },
        full,
        Options { full_transfer: Some(FullTransfer::Quadratic), ..full },
        Options { full_transfer: Some(FullTransfer::Linear), ..full },
    ] {
        let options = Options { tolerance: 1e-10, ..options };
        let discretisation = Discretisation::new(&hierarchy, &problem, &options).unwrap();
        let solution = discretisation.solve(&options).unwrap();
        let worst = solution.values.iter().zip(&exact).map(|(u, e)| (u - e).abs());
        assert!(worst.fold(0.0, f64::max) < 1e-9);
    }
}

/// As many iterations for six local levels as for two.
#[test]
fn iterations_do_not_grow_with_the_number_of_local_levels() {
    let iterations = |rounds: usize| {
        let hierarchy = hierarchy(rounds);
        let options = Options::default();
        let discretisation = Discretisation::new(&hierarchy, &problem(), &options).unwrap();
        discretisation.solve(&options).unwrap().report.iterations
    };
    let [few, many] = [2, 6].map(iterations);
    println!("{few} {many}");
    assert!(many <= few + 2, "{few} iterations, then {many}");
}
