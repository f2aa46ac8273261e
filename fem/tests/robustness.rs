//! Input that makes no sense, or too much of it: a right answer or a typed error.

use octruss_fem::*;
use octruss_mesh::shapes::kuhn_cube;
use octruss_mesh::{FeatureOptions, Hierarchy, RawMesh, Scheme, TetMesh, check, linear_matrix};
use octruss_solver::Error;
use octruss_solver::*;
use std::ops::ControlFlow;

/// Twice refined, u = 0 at x = 0 only.
struct Case {
    system: System,
    prolongations: Vec<Csr<f64>>,
}

fn case(coarse: TetMesh, problem: &Poisson) -> Case {
    let mut hierarchy = Hierarchy::new(coarse, &FeatureOptions::default());
    for _ in 0..2 {
        hierarchy.subdivide(Scheme::Linear).unwrap();
    }
    let dofs: Vec<Dofs> = hierarchy
        .levels()
        .iter()
        .map(|level| Dofs::new(&level.mesh, &problem.fixed).unwrap())
        .collect();
    let prolongation = |level: usize| {
        let matrix = linear_matrix(&hierarchy.levels()[level].topology);
        restrict_to_free(&matrix, &dofs[level + 1], &dofs[level]).unwrap()
    };
    Case {
        system: assemble(&hierarchy.finest().mesh, &hierarchy.levels()[2].topology, problem)
            .unwrap(),
        prolongations: [0, 1].map(prolongation).into(),
    }
}

impl Case {
    /// The solver's verdict; where that is success, the residual is looked at.
    fn solve(&self, matrix: &Csr<f64>, rhs: &[f64]) -> Result<usize, Error> {
        let options = MultigridOptions::default();
        let mut multigrid = Multigrid::new(matrix, self.prolongations.clone(), &options)?;
        let goal = SolveOptions::default();
        let (x, report) = conjugate_gradients(matrix, rhs, &mut multigrid, &goal)?;
        let mut r = vec![0.0; rhs.len()];
        kernels::residual(matrix, &x, rhs, &mut r);
        let is_small = norm(&r) <= 1.01e-8 * norm(rhs);
        let is_rounding = backward_error(matrix, &x, rhs) < 1e-13;
        assert!(is_small || is_rounding, "a wrong answer passed as right");
        Ok(report.iterations)
    }

    fn solve_itself(&self) -> Result<usize, Error> {
        self.solve(&self.system.matrix, &self.system.rhs)
    }
}

fn fixed_at_x0(coefficient: ByRegion) -> Poisson {
    let fixed = vec![(1, 0.0.into())];
    Poisson { coefficient, source: 1.0.into(), fixed, ..Poisson::default() }
}

/// The matrix with `change(row, column, value)` for its values.
fn changed(matrix: &Csr<f64>, change: impl Fn(usize, usize, f64) -> f64) -> Csr<f64> {
    let mut values = Vec::new();
    for row in 0..matrix.rows() {
        let (columns, row_values) = matrix.row(row);
        values.extend(columns.iter().zip(row_values).map(|(&j, &v)| change(row, j as usize, v)));
    }
    let offsets = (0..=matrix.rows()).map(|row| matrix.offset(row)).collect();
    Csr::new(matrix.columns(), offsets, matrix.indices().to_vec(), values).unwrap()
}

#[test]
fn a_singular_matrix_is_refused_and_a_nearly_singular_one_solved() {
    // Minus the row sums on the diagonal: constants are not seen any more.
    let case = case(kuhn_cube(2), &fixed_at_x0(1.0.into()));
    let (matrix, rhs) = (&case.system.matrix, &case.system.rhs);
    let off_diagonal = |row: usize| -> f64 {
        let (columns, values) = matrix.row(row);
        columns.iter().zip(values).filter(|(j, _)| **j as usize != row).map(|(_, v)| v).sum()
    };
    let plus = |shift: f64| {
        changed(matrix, |i, j, v| if i == j { -(1.0 + shift) * off_diagonal(i) } else { v })
    };
    // The prolongation, which knows of x = 0, hides the constants from the coarsest
    // level, conjugate gradients meet them; without levels the factors do.
    let refused = case.solve(&plus(0.0), rhs).unwrap_err();
    assert!(matches!(refused, Error::NotPositiveDefinite { .. }), "{refused}");
    assert!(refused.to_string().contains("enough is fixed"));
    let refused = Multigrid::new(&plus(0.0), vec![], &Default::default()).unwrap_err();
    assert!(matches!(refused, Error::CoarsestSingular { .. }), "{refused}");
    assert!(refused.to_string().contains("enough is fixed"));
    for shift in [1e-4, 1e-8, 1e-11, 1e-13] {
        match case.solve(&plus(shift), rhs) {
            Ok(iterations) => assert!(iterations < 60, "{shift}: {iterations}"),
            Err(Error::CoarsestSingular { .. }) => assert!(shift < 1e-7, "{shift} is solvable"),
            Err(Error::NotConverged(at) | Error::NotPositiveDefinite { at, .. }) => {
                assert!(shift < 1e-7 && at.report.residual_history.len() > 1, "{shift}");
            }
            Err(error) => panic!("{shift}: {error}"),
        }
    }
}

#[test]
fn indefinite_matrices_are_no_silent_wrong_answers() {
    let case = case(kuhn_cube(2), &fixed_at_x0(1.0.into()));
    let (matrix, rhs) = (&case.system.matrix, &case.system.rhs);
    // A − shift diag(A): more and more negative eigenvalues.
    for shift in [0.001, 0.01, 0.1, 0.5, 0.9, 1.5] {
        let indefinite = changed(matrix, |i, j, v| if i == j { (1.0 - shift) * v } else { v });
        match case.solve(&indefinite, rhs) {
            Ok(_) => assert!(shift < 0.02, "{shift} leaves no definite matrix"),
            Err(Error::NotPositiveDefinite { at, .. }) => {
                assert!(at.iterate.iter().all(|x| x.is_finite()));
                assert_eq!(at.report.residual_history.len(), at.report.iterations + 1);
            }
            Err(Error::NotConverged(at)) => assert!(at.iterate.iter().all(|x| x.is_finite())),
            Err(Error::Diagonal { value, .. }) => assert!(value <= 0.0),
            Err(Error::CoarsestSingular { .. }) => {}
            Err(error) => panic!("{shift}: {error}"),
        }
    }
}

#[test]
fn numbers_that_are_none_are_named() {
    let case = case(kuhn_cube(2), &fixed_at_x0(1.0.into()));
    let (matrix, rhs) = (&case.system.matrix, &case.system.rhs);
    for bad in [f64::NAN, f64::INFINITY] {
        let spoilt = changed(matrix, |i, j, v| if (i, j) == (3, 3) { bad } else { v });
        let index = matrix.offset(3) + matrix.row(3).0.binary_search(&3).unwrap();
        let refused = case.solve(&spoilt, rhs).unwrap_err();
        assert!(matches!(refused, Error::NotFinite { index: at, .. } if at == index), "{refused}");
        let mut spoilt = rhs.clone();
        spoilt[5] = bad;
        let refused = case.solve(matrix, &spoilt).unwrap_err();
        assert!(matches!(refused, Error::NotFinite { index: 5, .. }), "{refused}");
        let mut prolongations = case.prolongations.clone();
        prolongations[0] = changed(&prolongations[0], |i, _, v| if i == 0 { bad } else { v });
        let refused = Multigrid::new(matrix, prolongations, &Default::default());
        assert!(matches!(refused, Err(Error::NotFinite { index: 0, .. })));
    }
}

/// Eight cells, checkered by two regions.
fn checkered() -> TetMesh {
    let mut raw = kuhn_cube(2).into_raw();
    for t in 0..raw.tets.len() {
        let centroid =
            |k: usize| raw.tets[t].iter().map(|&v| raw.points[v as usize][k]).sum::<f64>() / 4.0;
        let odd = (0..3).filter(|&k| centroid(k) > 0.5).count() % 2;
        raw.regions[t] = odd as i32;
    }
    check(raw, &Default::default()).unwrap().mesh
}

#[test]
fn extreme_coefficients() {
    // The same everywhere, in any units: the same iterations.
    let counts = [1e-12, 1.0, 1e12]
        .map(|k: f64| case(kuhn_cube(2), &fixed_at_x0(k.into())).solve_itself().unwrap());
    assert_eq!(counts, [counts[1]; 3]);
    // Jumps across all faces between cells. Beyond 1e12 the residual that rounding
    // leaves may exceed the goal.
    for (low, high) in [(1.0, 1e3), (1e-3, 1e3), (1e-6, 1e6), (1e-12, 1e12)] {
        let mut coefficient = ByRegion::from(low);
        coefficient.regions.push((1, high.into()));
        match case(checkered(), &fixed_at_x0(coefficient)).solve_itself() {
            Ok(iterations) => assert!(iterations <= 40, "{low} {high}: {iterations}"),
            Err(Error::NotConverged(at)) => {
                assert!(high / low > 1e9, "{low} {high}: {:?}", at.report);
                assert!(at.iterate.iter().all(|x| x.is_finite()));
            }
            Err(Error::CoarsestSingular { .. }) => assert!(high / low > 1e12),
            Err(error) => panic!("{low} {high}: {error}"),
        }
    }
}

/// Soft and nearly incompressible at the bottom, elsewhere `contrast` times as stiff;
/// springs of the soft stiffness hold the top.
fn soft_base(contrast: f64) -> (VectorSystem, Vec<Csr<f64>>) {
    let mut raw = kuhn_cube(2).into_raw();
    for t in 0..raw.tets.len() {
        let height = raw.tets[t].iter().map(|&v| raw.points[v as usize][2]).sum::<f64>() / 4.0;
        raw.regions[t] = i32::from(height > 0.5);
    }
    let coarse = check(raw, &Default::default()).unwrap().mesh;
    let mut hierarchy = Hierarchy::new(coarse, &FeatureOptions::default());
    (0..3).for_each(|_| hierarchy.subdivide(Scheme::Linear).unwrap());
    let material =
        |young, poisson| Material { density: 1.0.into(), ..Material::new(young, poisson) };
    let mut by_region = ByRegion::from(material(contrast, 0.3));
    by_region.regions.push((0, material(1.0, 0.45)));
    let [zero, one] = [0.0, 1.0].map(Scalar::from);
    let problem = Elasticity {
        gravity: [zero.clone(), one.clone(), zero],
        springs: vec![(6, Stiffness::Axes([one.clone(), one.clone(), one]))],
        ..Elasticity::new(by_region)
    };
    let system =
        assemble_elasticity(&hierarchy.finest().mesh, &hierarchy.levels()[3].topology, &problem)
            .unwrap();
    let dofs = |level: usize| Dofs::new(&hierarchy.levels()[level].mesh, &[]).unwrap();
    let prolongations = [0, 1, 2].map(|level| {
        let matrix = linear_matrix(&hierarchy.levels()[level].topology);
        restrict_to_free(&matrix, &dofs(level + 1), &dofs(level)).unwrap()
    });
    (system, prolongations.into())
}

#[test]
fn soft_material_beside_hard_costs_few_iterations_more() {
    let smoothers =
        [(Smoother::CHEBYSHEV, 15), (Smoother::HybridGaussSeidel, 25), (Smoother::L1Jacobi, 50)];
    for contrast in [1.0, 1e3, 1e6] {
        let (system, prolongations) = soft_base(contrast);
        for (smoother, alike) in smoothers {
            let options = MultigridOptions { smoother: Some(smoother), ..Default::default() };
            let mut multigrid =
                Multigrid::new(&system.matrix, prolongations.clone(), &options).unwrap();
            // Rounding allows no more than 2e-6 where the body is a million times as
            // stiff as what holds it.
            let goal = SolveOptions { tolerance: 1e-5, ..Default::default() };
            let (matrix, rhs) = (&system.matrix, &system.rhs);
            let solved = conjugate_gradients(matrix, rhs, &mut multigrid, &goal);
            let count = solved.unwrap().1.iterations;
            let bound = if contrast == 1.0 { alike } else { alike * 3 / 2 };
            assert!(count <= bound, "{contrast}, {smoother:?}: {count}");
        }
    }
}

#[test]
fn slivers_cost_iterations_but_no_answer() {
    // The middle vertex of the cube is moved towards a corner of its cell: tets at
    // that corner become flat.
    let sliver = |flatness: f64| {
        let mut raw: RawMesh = kuhn_cube(2).into_raw();
        let middle = raw.points.iter().position(|p| *p == [0.5; 3]).unwrap();
        // From (½, ½, ½) almost to (½, ½, 1), an edge's other end.
        raw.points[middle] = [0.5, 0.5, 1.0 - 0.5 * flatness];
        check(raw, &Default::default()).unwrap().mesh
    };
    let solve = |flatness: f64| case(sliver(flatness), &fixed_at_x0(1.0.into())).solve_itself();
    let counts = [1.0, 1e-1, 1e-2].map(|flatness| solve(flatness).unwrap());
    assert!(counts[0] <= 9 && counts.iter().all(|count| *count <= 60), "{counts:?}");
    // So flat that hundreds of eigenvalues lie far out.
    for flatness in [1e-3, 1e-6, 1e-9] {
        match solve(flatness) {
            Ok(_) => {}
            Err(Error::NotConverged(at)) => {
                let history = at.report.residual_history;
                assert_eq!(history.len(), SolveOptions::default().max_iterations + 1);
                assert!(at.iterate.iter().all(|x| x.is_finite()) && flatness < 1e-3);
            }
            Err(error) => panic!("{flatness}: {error}"),
        }
    }
}

#[test]
fn a_stopped_solve_keeps_the_best_iterate() {
    let case = case(kuhn_cube(2), &fixed_at_x0(1.0.into()));
    let (matrix, rhs) = (&case.system.matrix, &case.system.rhs);
    let stop = |iteration: usize, _: f64| match iteration {
        3 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    };
    let goal = SolveOptions { progress: Some(&stop), ..SolveOptions::default() };
    let fresh = || Multigrid::new(matrix, case.prolongations.clone(), &Default::default()).unwrap();
    let solved = conjugate_gradients(matrix, rhs, &mut fresh(), &goal);
    let Err(Error::Stopped(at)) = solved else { panic!("not stopped") };
    assert_eq!((at.report.iterations, at.iterate.len()), (3, rhs.len()));
    assert!(at.report.relative_residual < 0.05);

    // x ← x + 1.2 · (cycle): each iteration makes the smooth error smaller; three
    // times a cycle diverges from the first.
    struct Times(f64, Multigrid);
    impl Preconditioner for Times {
        fn apply(&mut self, r: &[f64], z: &mut [f64]) {
            self.1.apply(r, z);
            z.iter_mut().for_each(|z| *z *= self.0);
        }
    }
    let solved = stationary_iteration(matrix, rhs, &mut Times(3.0, fresh()), &goal);
    let Err(Error::Stopped(at)) = solved else { panic!("not stopped") };
    let smallest = at.report.residual_history.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((at.report.relative_residual / smallest - 1.0).abs() < 1e-9);
    assert!(at.report.residual_history[3] > 2.0 * smallest, "it does diverge");
}
