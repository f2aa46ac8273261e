//! Multigrid on blocks: iterations for elasticity known from measurement, and
//! constrained directions.

mod elastic;

use elastic::{Block, Body, body};
use octruss_mesh::Scheme;
use octruss_mesh::shapes::kuhn_cube;
use octruss_solver::Error;
use octruss_solver::*;

const GAUSS_SEIDEL: MultigridOptions = MultigridOptions {
    smoother: Some(Smoother::GaussSeidel),
    diagonal: DiagonalKind::Block,
    shape: CycleShape::V,
    before: 1,
    after: 1,
    precision: Some(Precision::Double),
};

/// The unit cube, clamped at x = 0, on 2³ cells refined three times: 13,872 unknowns.
fn cube(prolong: Scheme) -> Body {
    body(kuhn_cube(2), 3, (prolong, 0.3, 1), |_| None)
}

/// Noise in the free directions.
fn right_side(body: &Body) -> Vec<[f64; 3]> {
    let numbers = noise(3 * body.matrix.rows(), 21);
    let mut rhs: Vec<[f64; 3]> = numbers.as_chunks::<3>().0.to_vec();
    for (row, q) in body.projectors.last().unwrap() {
        let b = rhs[*row as usize];
        rhs[*row as usize] = q.map(|q| q[0] * b[0] + q[1] * b[1] + q[2] * b[2]);
    }
    rhs
}

fn solve(body: &Body, options: &MultigridOptions) -> (Vec<[f64; 3]>, SolveReport) {
    let prolongations = body.prolongations.clone();
    let projectors = body.projectors.clone();
    let mut multigrid =
        Multigrid::constrained(&body.matrix, prolongations, projectors, options).unwrap();
    let goal = SolveOptions::default();
    conjugate_gradients(&body.matrix, &right_side(body), &mut multigrid, &goal).unwrap()
}

#[test]
fn the_cube_takes_the_measured_iterations() {
    // A prototype with pointwise Gauss–Seidel took 16 and 12 with linear, 14 and 8
    // with box-spline prolongation; blocks differ by one at most.
    let v22 = MultigridOptions { before: 2, after: 2, ..GAUSS_SEIDEL };
    for (scheme, bounds) in [(Scheme::Linear, [17, 13]), (Scheme::BoxSpline, [15, 9])] {
        let cube = cube(scheme);
        let counts = [GAUSS_SEIDEL, v22].map(|options| solve(&cube, &options).1.iterations);
        assert!(counts[0] <= bounds[0] && counts[1] <= bounds[1], "{scheme:?}: {counts:?}");
        for options in [GAUSS_SEIDEL, MultigridOptions::default()] {
            let precise =
                solve(&cube, &MultigridOptions { precision: Some(Precision::Double), ..options });
            let single =
                solve(&cube, &MultigridOptions { precision: Some(Precision::Single), ..options });
            let counts = [precise, single].map(|solved| solved.1.iterations);
            assert!(counts[0].abs_diff(counts[1]) <= 1, "{scheme:?}: {counts:?}");
        }
    }
}

#[test]
fn domains_cost_few_iterations_on_every_level() {
    for levels in [3, 4] {
        let cube = body(kuhn_cube(2), levels, (Scheme::Linear, 0.3, 1), |_| None);
        let hybrid =
            MultigridOptions { smoother: Some(Smoother::HybridGaussSeidel), ..GAUSS_SEIDEL };
        let counts = [GAUSS_SEIDEL, hybrid].map(|options| solve(&cube, &options).1.iterations);
        assert!(counts[1] <= counts[0] + 2 && counts[1] <= 18, "{counts:?}");
    }
}

#[test]
fn auto_sweeps_by_domains_where_blocks_are_solved() {
    let smoother = |diagonal| {
        let body = cube(Scheme::Linear);
        let options = MultigridOptions { diagonal, ..Default::default() };
        let multigrid = Multigrid::new(&body.matrix, body.prolongations, &options);
        multigrid.unwrap().options().smoother
    };
    assert_eq!(smoother(DiagonalKind::Block), Smoother::HybridGaussSeidel);
    assert_eq!(smoother(DiagonalKind::Point), Smoother::CHEBYSHEV);
}

#[test]
fn every_smoother_and_shape_converges() {
    let cube = cube(Scheme::Linear);
    let double = MultigridOptions { precision: Some(Precision::Double), ..Default::default() };
    let with = |smoother| MultigridOptions { smoother: Some(smoother), ..double };
    let chebyshev = |degree| with(Smoother::Chebyshev { degree, lower: 0.1 });
    let choices = [
        chebyshev(1),
        chebyshev(2),
        chebyshev(3),
        chebyshev(4),
        MultigridOptions { diagonal: DiagonalKind::Point, ..chebyshev(3) },
        with(Smoother::ColouredGaussSeidel),
        with(Smoother::HybridGaussSeidel),
        with(Smoother::L1Jacobi),
        MultigridOptions { diagonal: DiagonalKind::Point, ..with(Smoother::L1Jacobi) },
        MultigridOptions { shape: CycleShape::W, ..chebyshev(2) },
        MultigridOptions { after: 0, ..chebyshev(2) },
        MultigridOptions { shape: CycleShape::W, ..with(Smoother::HybridGaussSeidel) },
        MultigridOptions { before: 0, ..with(Smoother::HybridGaussSeidel) },
    ];
    let counts = choices.map(|options| solve(&cube, &options).1.iterations);
    assert!(counts[..4].is_sorted_by(|a, b| a >= b), "a higher degree is no worse: {counts:?}");
    assert!(counts.iter().all(|count| *count <= 40), "{counts:?}");
    assert!(counts[9] <= counts[1] && counts[11] <= counts[6], "W is no worse than V: {counts:?}");
}

/// The projector onto the plane with this normal, not of length 1.
fn plane(normal: [f64; 3]) -> Block {
    let square: f64 = normal.iter().map(|n| n * n).sum();
    let kronecker = |i, j| if i == j { 1.0 } else { 0.0 };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| kronecker(i, j) - normal[i] * normal[j] / square))
}

#[test]
fn constrained_directions_stay_so_and_cost_no_iterations() {
    // A slanted plane holds the side y = 1; some vertices of z = 1 may only move
    // along z, and one line of it is held altogether without being dropped.
    let free = |[x, y, z]: [f64; 3]| match (y == 1.0, z == 1.0) {
        (true, true) => Some([[0.0; 3]; 3]),
        (true, false) => Some(plane([1.0, 2.0, -2.0])),
        (false, true) if x > 0.4 => Some([[0.0; 3], [0.0; 3], [0.0, 0.0, 1.0]]),
        _ => None,
    };
    for scheme in [Scheme::Linear, Scheme::BoxSpline] {
        let body = body(kuhn_cube(2), 3, (scheme, 0.3, 1), free);
        for options in [
            MultigridOptions::default(),
            MultigridOptions { diagonal: DiagonalKind::Point, ..Default::default() },
            MultigridOptions { smoother: Some(Smoother::L1Jacobi), ..Default::default() },
            GAUSS_SEIDEL,
        ] {
            let (x, report) = solve(&body, &options);
            // The rows held altogether are unknowns that no other sees, so they
            // cost nothing; l1-Jacobi is slow everywhere.
            assert!(report.iterations <= 45, "{} {options:?}", report.iterations);
            let size = norm(&x);
            for (row, q) in body.projectors.last().unwrap() {
                let x = x[*row as usize];
                for i in 0..3 {
                    let projected: f64 = (0..3).map(|j| q[i][j] * x[j]).sum();
                    assert!((projected - x[i]).abs() <= 1e-7 * size, "row {row}");
                }
            }
        }
        let held = solve(&body, &MultigridOptions::default()).1.iterations;
        let unheld = solve(&cube(scheme), &MultigridOptions::default()).1.iterations;
        assert!(held <= unheld + 2, "{scheme:?}: {held} against {unheld}");
    }
}

#[test]
fn a_coarsest_mesh_without_order_costs_iterations_but_not_convergence() {
    // Neighbours on the coarsest level are far from each other in its numbering, so
    // domains are scattered.
    let counts = [false, true].map(|is_shuffled| {
        let mut raw = kuhn_cube(13).into_raw();
        if is_shuffled {
            let n = raw.points.len();
            let new = |old: usize| old * 101 % n;
            let old = raw.points.clone();
            (0..n).for_each(|k| raw.points[new(k)] = old[k]);
            raw.tets.iter_mut().flatten().for_each(|v| *v = new(*v as usize) as u32);
            raw.triangles.simplices.iter_mut().flatten().for_each(|v| *v = new(*v as usize) as u32);
        }
        let mesh = octruss_mesh::check(raw, &Default::default()).unwrap().mesh;
        let body = body(mesh, 1, (Scheme::Linear, 0.3, 1), |_| None);
        solve(&body, &MultigridOptions::default()).1.iterations
    });
    assert!(counts[1] <= counts[0] + 6, "{counts:?}");
}

#[test]
fn an_updated_multigrid_of_blocks_is_that_built_anew_to_the_last_bit() {
    let free = |[_, y, _]: [f64; 3]| (y == 1.0).then(|| plane([1.0, 2.0, -2.0]));
    for scheme in [Scheme::Linear, Scheme::BoxSpline] {
        let bodies = [0.3, 0.45].map(|nu| body(kuhn_cube(2), 2, (scheme, nu, 1), free));
        let build = |body: &Body| {
            let (prolongations, projectors) = (body.prolongations.clone(), body.projectors.clone());
            let options = MultigridOptions::default();
            Multigrid::constrained(&body.matrix, prolongations, projectors, &options).unwrap()
        };
        let applied = |mut multigrid: Multigrid<Block>| {
            let mut z = vec![[0.0; 3]; bodies[1].matrix.rows()];
            multigrid.apply(&right_side(&bodies[1]), &mut z);
            (z, multigrid.levels().to_vec())
        };
        let updated = build(&bodies[0]).updated(&bodies[1].matrix).unwrap();
        assert_eq!(applied(updated), applied(build(&bodies[1])));
    }
}

#[test]
fn smoothed_prolongation_respects_constrained_directions() {
    // One side slides on a slanted plane, a line of another is held without being dropped.
    let free = |[x, y, z]: [f64; 3]| match (y == 1.0, z == 1.0 && x > 0.4) {
        (_, true) => Some([[0.0; 3]; 3]),
        (true, _) => Some(plane([1.0, 2.0, -2.0])),
        _ => None,
    };
    let body = body(kuhn_cube(2), 3, (Scheme::Linear, 0.3, 1), free);
    let iterations = |smooth: bool| {
        let transfers = body
            .prolongations
            .iter()
            .map(|prolongation| Transfer { smooth, ..Transfer::from(prolongation.clone()) });
        let (transfers, projectors) = (transfers.collect(), body.projectors.clone());
        let options = MultigridOptions { before: 2, after: 2, ..GAUSS_SEIDEL };
        let mut multigrid = Multigrid::with_transfers(
            &body.matrix,
            transfers,
            projectors,
            NearNullSpace::Constants,
            &options,
        )
        .unwrap();
        let goal = SolveOptions::default();
        let rhs = right_side(&body);
        let (x, report) = conjugate_gradients(&body.matrix, &rhs, &mut multigrid, &goal).unwrap();
        for (row, q) in body.projectors.last().unwrap() {
            let x = x[*row as usize];
            let left = [0, 1, 2].map(|i| x[i] - (0..3).map(|j| q[i][j] * x[j]).sum::<f64>());
            assert!(norm(&left) <= 1e-7 * norm(&[x]).max(1.0), "row {row}: {left:?}");
        }
        report.iterations
    };
    let (smoothed, linear) = (iterations(true), iterations(false));
    assert!(smoothed < linear, "{smoothed} {linear}");
}

#[test]
fn blocks_have_the_same_bits_for_any_number_of_threads() {
    let cube = cube(Scheme::BoxSpline);
    for smoother in
        [Smoother::CHEBYSHEV, Smoother::HybridGaussSeidel, Smoother::ColouredGaussSeidel]
    {
        let options = MultigridOptions { smoother: Some(smoother), ..Default::default() };
        let solutions = [1, 2, 3].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| solve(&cube, &options).0)
        });
        assert_eq!(solutions[0], solutions[1]);
        assert_eq!(solutions[0], solutions[2]);
    }
}

#[test]
fn projectors_that_are_none_are_refused() {
    let cube = cube(Scheme::Linear);
    let refused = |list: Vec<(u32, Block)>| {
        let mut lists = vec![Vec::new(); 4];
        lists[3] = list;
        let prolongations = cube.prolongations.clone();
        Multigrid::constrained(&cube.matrix, prolongations, lists, &Default::default()).unwrap_err()
    };
    let slanted = plane([1.0, 1.0, 0.0]);
    let twice = slanted.map(|row| row.map(|v| 2.0 * v));
    assert!(matches!(refused(vec![(3, twice)]), Error::Projector { level: 3, row: 3 }));
    let descending = vec![(3, slanted), (2, slanted)];
    assert!(matches!(refused(descending), Error::Projector { row: 2, .. }));
    assert!(matches!(refused(vec![(4624, slanted)]), Error::Size { found: 4624, .. }));
}
