//! A problem solved in one call, and what its options must agree in.

use octruss_fem::{
    CoarseOperator, Cycle, Discretisation, Error, FullTransfer, Options, Poisson, assemble,
};
use octruss_mesh::shapes::kuhn_cube;
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme};
use octruss_solver::{Multigrid, SolveOptions, conjugate_gradients};

fn hierarchy() -> Hierarchy {
    let mut hierarchy = Hierarchy::new(kuhn_cube(2), &FeatureOptions::default());
    (0..2).for_each(|_| hierarchy.subdivide(Scheme::Linear).unwrap());
    hierarchy
}

/// −Δu = 1, u = 2 on all sides.
fn problem() -> Poisson {
    let fixed = (1..=6).map(|side| (side, 2.0.into())).collect();
    Poisson { source: 1.0.into(), fixed, ..Poisson::default() }
}

#[test]
fn whatever_the_options_the_solution_is_that_of_the_direct_solver() {
    let (hierarchy, problem) = (hierarchy(), problem());
    let finest = hierarchy.finest();
    let system = assemble(&finest.mesh, &finest.topology, &problem).unwrap();
    let mut direct = Multigrid::new(&system.matrix, vec![], &Default::default()).unwrap();
    let goal = SolveOptions { tolerance: 1e-13, ..SolveOptions::default() };
    let exact = conjugate_gradients(&system.matrix, &system.rhs, &mut direct, &goal).unwrap().0;
    let exact = system.expand(&exact).unwrap();
    let full = Options { cycle: Some(Cycle::Full), ..Options::default() };
    for options in [
        Options::default(),
        Options { prolongation: Some(Scheme::Linear.into()), ..Options::default() },
        Options { coarse_operator: CoarseOperator::Reassembled, ..Options::default() },
        full,
        Options { full_transfer: Some(FullTransfer::Linear), ..full },
    ] {
        let options = Options { tolerance: 1e-10, ..options };
        let discretisation = Discretisation::new(&hierarchy, &problem, &options).unwrap();
        assert_eq!(discretisation.matrix, system.matrix);
        assert_eq!(discretisation.rhs, system.rhs);
        let solution = discretisation.solve(&options).unwrap();
        let worst = solution.values.iter().zip(&exact).map(|(u, e)| (u - e).abs());
        assert!(worst.fold(0.0, f64::max) < 1e-9);
        assert_eq!(solution.full_multigrid_residual.is_some(), options.cycle == Some(Cycle::Full));
    }
}

#[test]
fn what_was_not_assembled_is_asked_for_and_not_left_out() {
    let (hierarchy, problem) = (hierarchy(), problem());
    let plain = Discretisation::new(&hierarchy, &problem, &Options::default()).unwrap();
    let refused = |options: Options| match plain.solve(&options) {
        Err(Error::Solver(octruss_solver::Error::Option { option, .. })) => option,
        _ => "none",
    };
    let reassembled =
        Options { coarse_operator: CoarseOperator::Reassembled, ..Options::default() };
    assert_eq!(refused(reassembled), "coarse_operator");
    assert_eq!(refused(Options { cycle: Some(Cycle::Full), ..Options::default() }), "cycle");
    assert_eq!(refused(Options { cycle: Some(Cycle::W), ..Options::default() }), "none");
}
