//! Bodies that nothing holds: their loads are balanced, and of all solutions the one without
//! mean or rigid motion is found.

use octruss_fem::*;
use octruss_mesh::shapes::{kuhn_box, kuhn_cube};
use octruss_mesh::{FeatureOptions, Hierarchy, RawMesh, Scheme, TetMesh, check};

fn refined(mesh: TetMesh, refinements: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    (0..refinements).for_each(|_| hierarchy.subdivide(Scheme::Linear).unwrap());
    hierarchy
}

/// With and without full multigrid, with and without re-assembled coarse matrices, by cycles
/// alone.
fn options() -> [Options; 4] {
    let tight = Options {
        tolerance: 1e-11,
        prolongation: Some(Scheme::Linear.into()),
        ..Options::default()
    };
    [
        tight,
        Options { cycle: Some(Cycle::Full), ..tight },
        Options { coarse_operator: CoarseOperator::Reassembled, ..tight },
        Options { method: Some(Method::Cycle), ..tight },
    ]
}

struct Solved<'h, E: Unknown> {
    discrete: Discretisation<'h, E>,
    solution: Solution<E>,
}

fn solve<'h, P: Problem>(
    hierarchy: &'h Hierarchy,
    problem: &P,
    options: &Options,
) -> Solved<'h, P::Entry> {
    let discrete = Discretisation::new(hierarchy, problem, options).unwrap();
    let solution = discrete.solve(options).unwrap();
    Solved { discrete, solution }
}

/// The volume round each vertex.
fn volumes(mesh: &TetMesh) -> Vec<f64> {
    let mut volumes = vec![0.0; mesh.points().len()];
    for (t, tet) in mesh.tets().iter().enumerate() {
        tet.iter().for_each(|&v| volumes[v as usize] += 0.25 * mesh.volume(t));
    }
    volumes
}

/// A mesh and another beside it, whose tags are 10 higher.
fn both(a: TetMesh, b: &TetMesh, away: [f64; 3]) -> TetMesh {
    let mut raw: RawMesh = a.into_raw();
    let first = raw.points.len() as u32;
    raw.points.extend(b.points().iter().map(|p| [0, 1, 2].map(|k| p[k] + away[k])));
    raw.tets.extend(b.tets().iter().map(|tet| tet.map(|v| v + first)));
    raw.regions.extend(b.regions());
    for (triangle, tag) in b.triangles().iter() {
        raw.triangles.push(triangle.map(|v| v + first), tag + 10);
    }
    check(raw, &Default::default()).unwrap().mesh
}

// Poisson.

#[test]
fn a_linear_solution_comes_from_its_fluxes_alone() {
    // u = 2 x − 3 y + z / 2 less its mean, with what flows in on all sides of two cubes.
    let slope = [2.0, -3.0, 0.5];
    let hierarchy = refined(both(kuhn_cube(2), &kuhn_cube(1), [3.0, 0.0, 0.0]), 2);
    let flux = |side: i32| {
        let sign = if side % 2 == 0 { 1.0 } else { -1.0 };
        (side, Scalar::from(sign * slope[(side as usize - 1) % 10 / 2]))
    };
    let problem = Poisson {
        flux: (1..=6).chain(11..=16).map(flux).collect(),
        free: Free::Balance,
        ..Poisson::default()
    };
    for options in options() {
        let Solved { discrete, solution } = solve(&hierarchy, &problem, &options);
        for (u, p) in solution.values.iter().zip(hierarchy.finest().mesh.points()) {
            let centre = [if p[0] > 2.0 { 3.5 } else { 0.5 }, 0.5, 0.5];
            let exact: f64 = (0..3).map(|k| slope[k] * (p[k] - centre[k])).sum();
            assert!((u - exact).abs() < 1e-9, "{u} for {exact}");
        }
        let free = discrete.free.unwrap();
        assert_eq!((free.null_space.dimension(), free.balances.len()), (2, 2));
        assert!(free.balances.iter().all(|balance| balance.share < 1e-14));
    }
}

#[test]
fn what_flows_in_without_end_is_balanced_by_a_uniform_source() {
    // A flux of 3 through z = 1: −u″ = −3, u′(0) = 0, so u = 3/2 (z² − 1/3).
    let errors = [2, 3].map(|refinements| {
        let hierarchy = refined(kuhn_cube(2), refinements);
        let problem =
            Poisson { flux: vec![(6, 3.0.into())], free: Free::Balance, ..Poisson::default() };
        let Solved { discrete, solution } = solve(&hierarchy, &problem, &options()[0]);
        let balance = discrete.free.as_ref().unwrap().balances[0];
        let Balancing::Source(source) = balance.added else { panic!("{balance:?}") };
        assert!((source + 3.0).abs() < 1e-12 && (balance.share - 1.0).abs() < 1e-12);
        let mesh = &hierarchy.finest().mesh;
        let mean: f64 = solution.values.iter().zip(volumes(mesh)).map(|(u, v)| u * v).sum();
        assert!(mean.abs() < 1e-12, "{mean}");
        l2_error(mesh, &solution.values, |[.., z]| 1.5 * (z * z - 1.0 / 3.0))
    });
    assert!(errors[0] / errors[1] > 3.5, "{errors:?}");
}

#[test]
fn a_free_part_does_not_touch_the_one_that_is_held() {
    let hierarchy = refined(both(kuhn_cube(1), &kuhn_cube(1), [3.0, 0.0, 0.0]), 3);
    let problem = |free: Free| Poisson {
        source: 1.0.into(),
        fixed: [1, 2].iter().map(|&side| (side, 1000.0.into())).collect(),
        flux: vec![(11, 1.0.into()), (12, (-1.0).into())],
        free,
        ..Poisson::default()
    };
    let refused = Discretisation::new(&hierarchy, &problem(Free::Refuse), &options()[0]);
    let told = refused.err().unwrap().to_string();
    assert!(told.contains("nothing is fixed") && told.contains("free = \"balance\""), "{told}");
    for options in options() {
        let solution = solve(&hierarchy, &problem(Free::Balance), &options).solution;
        // The source of 1 is balanced on the free part, which keeps −u′ = 1; on the other
        // it heats: x (1 − x) / 2.
        for (u, [x, ..]) in solution.values.iter().zip(hierarchy.finest().mesh.points()) {
            let exact = if *x > 2.0 { 3.5 - x } else { 1000.0 + 0.5 * x * (1.0 - x) };
            let bound = if *x > 2.0 { 1e-9 } else { 5e-3 };
            assert!((u - exact).abs() < bound, "{u} for {exact} at {x}");
        }
    }
}

#[test]
fn a_free_body_takes_about_the_iterations_of_a_held_one() {
    let hierarchy = refined(kuhn_cube(2), 3);
    let source = Scalar::function(|[x, y, z]| x * y - 3.0 * z);
    let free =
        Poisson { source: ByRegion::from(source), free: Free::Balance, ..Poisson::default() };
    let held = Poisson { fixed: vec![(1, 0.0.into())], ..free.clone() };
    for prolongation in [Scheme::Linear, Scheme::BoxSpline] {
        let options = Options { prolongation: Some(prolongation.into()), ..Options::default() };
        let [free, held] = [&free, &held]
            .map(|problem| solve(&hierarchy, problem, &options).solution.report.iterations);
        println!("Poisson, {}: free {free}, held {held}", prolongation.name());
        assert!(2 * free <= 3 * held, "free {free}, held {held}");
    }
    let load = Scalar::function(|[x, y, _]| x * y - 0.3);
    let pulled = Elasticity {
        traction: vec![(2, [0.0.into(), load, 1.0.into()])],
        free: Free::Balance,
        ..Elasticity::new(Material::new(5.0, 0.3))
    };
    let clamp = Support { surface: 1, held: Held::displacement([0.0; 3]) };
    let held = Elasticity { supports: vec![clamp], ..pulled.clone() };
    let options = Options { prolongation: Some(Scheme::Linear.into()), ..Options::default() };
    let [free, held] = [&pulled, &held]
        .map(|problem| solve(&hierarchy, problem, &options).solution.report.iterations);
    println!("elasticity: free {free}, held {held}");
    assert!(2 * free <= 3 * held, "free {free}, held {held}");
}

// Elasticity.

type Body<'h> = Solved<'h, [[f64; 3]; 3]>;

fn stress_and_forces(
    hierarchy: &Hierarchy,
    problem: &Elasticity,
    Solved { discrete, solution }: &Body,
) -> (Vec<[f64; 6]>, Forces) {
    let level = hierarchy.finest();
    let strain = strains(&level.mesh, solution.differences()).unwrap();
    let stress = stresses(&level.mesh, problem, &strain).unwrap();
    let mesh = (&level.mesh, &level.topology);
    let constraints = &discrete.constraints;
    let forces = Forces::new(mesh, problem, constraints, &solution.values, &stress).unwrap();
    (stress, forces)
}

/// A bar of length 2 whose ends are pulled along x by these tractions.
fn bar(ends: [f64; 2], density: f64, poisson: f64) -> Elasticity {
    let material = Material { density: density.into(), ..Material::new(40.0, poisson) };
    let pull = |(side, t): (i32, f64)| (side, vector([t, 0.0, 0.0]));
    Elasticity {
        traction: [(1, ends[0]), (2, ends[1])].map(pull).to_vec(),
        free: Free::Balance,
        ..Elasticity::new(material)
    }
}

#[test]
fn a_bar_pulled_at_both_ends_is_stressed_evenly() {
    let hierarchy = refined(kuhn_box([4, 2, 2], [2.0, 1.0, 1.0]), 1);
    let problem = bar([-3.0, 3.0], 0.0, 0.3);
    for options in options() {
        let solved = solve(&hierarchy, &problem, &options);
        let (stress, forces) = stress_and_forces(&hierarchy, &problem, &solved);
        for stress in stress {
            assert!((stress[0] - 3.0).abs() < 1e-7, "{stress:?}");
            assert!(stress[1..].iter().all(|s| s.abs() < 1e-7), "{stress:?}");
        }
        assert!(forces.imbalance() < 1e-12 && forces.inertia.iter().all(|f| f.abs() < 1e-12));
        // Stretched by 3 / 40 about the middle, thinner by ν times that.
        for (u, p) in solved.solution.values.iter().zip(hierarchy.finest().mesh.points()) {
            let exact = [p[0] - 1.0, -0.3 * (p[1] - 0.5), -0.3 * (p[2] - 0.5)];
            for (u, exact) in u.iter().zip(exact) {
                assert!((u - 3.0 / 40.0 * exact).abs() < 1e-8, "{u} at {p:?}");
            }
        }
        let free = solved.discrete.free.unwrap();
        assert_eq!(free.null_space.dimension(), 6);
    }
}

#[test]
fn a_bar_pulled_at_one_end_is_stressed_by_its_inertia() {
    // t on the end x = 2 accelerates the mass 2 ρ by t / (2 ρ): σ = t x / 2, whether there is
    // a density or not. Layers of cells have their mean stress exactly.
    let layers = 8;
    let hierarchy = refined(kuhn_box([4, 2, 2], [2.0, 1.0, 1.0]), 1);
    let mesh = &hierarchy.finest().mesh;
    for density in [0.0, 7.85] {
        let problem = bar([0.0, 3.0], density, 0.0);
        let solved = solve(&hierarchy, &problem, &options()[0]);
        let (stress, forces) = stress_and_forces(&hierarchy, &problem, &solved);
        let mut means = vec![[0.0; 2]; layers];
        for (tet, stress) in stress.iter().enumerate() {
            let middle = mesh.corners(tet).iter().map(|p| p[0]).sum::<f64>() / 4.0;
            let mean = &mut means[(middle * layers as f64 / 2.0) as usize];
            mean[0] += mesh.volume(tet);
            mean[1] += mesh.volume(tet) * stress[0];
        }
        for (layer, [volume, sum]) in means.into_iter().enumerate() {
            let exact = 3.0 * (layer as f64 + 0.5) / layers as f64;
            assert!((sum / volume - exact).abs() < 1e-7, "{} for {exact}", sum / volume);
        }
        assert!((forces.loads[0] - 3.0).abs() < 1e-12 && (forces.inertia[0] + 3.0).abs() < 1e-12);
        assert!(forces.imbalance() < 1e-12);
        let balance = solved.discrete.free.as_ref().unwrap().balances[0];
        let Balancing::Acceleration { centre, linear, angular } = balance.added else {
            panic!("{balance:?}")
        };
        let mass = 2.0 * if density > 0.0 { density } else { 1.0 };
        let exact = [[1.0, 0.5, 0.5], [3.0 / mass, 0.0, 0.0], [0.0; 3]];
        for (found, exact) in [centre, linear, angular].iter().zip(exact) {
            for (found, exact) in found.iter().zip(exact) {
                assert!((found - exact).abs() < 1e-12, "{balance:?}");
            }
        }
    }
}

#[test]
fn a_couple_turns_a_body_by_its_moment_of_inertia() {
    // Shear s along ±y on the ends of a bar of length 2 and section 1 × 1: a moment of 2 s
    // about z; the mass 2 ρ resists it with 2 ρ (2² + 1²) / 12.
    let hierarchy = refined(kuhn_box([4, 2, 2], [2.0, 1.0, 1.0]), 1);
    let material = Material { density: 3.0.into(), ..Material::new(40.0, 0.3) };
    let problem = Elasticity {
        traction: vec![(1, vector([0.0, -1.5, 0.0])), (2, vector([0.0, 1.5, 0.0]))],
        free: Free::Balance,
        ..Elasticity::new(material)
    };
    let solved = solve(&hierarchy, &problem, &options()[0]);
    let (_, forces) = stress_and_forces(&hierarchy, &problem, &solved);
    assert!(forces.imbalance() < 1e-12);
    let balance = solved.discrete.free.as_ref().unwrap().balances[0];
    let Balancing::Acceleration { linear, angular, .. } = balance.added else { panic!() };
    let exact = 2.0 * 1.5 / (2.0 * 3.0 * 5.0 / 12.0);
    assert!((angular[2] - exact).abs() < 1e-12, "{angular:?} for {exact}");
    assert!(linear.iter().chain(&angular[..2]).all(|a| a.abs() < 1e-12), "{balance:?}");
    // No net motion, and no net rotation: ∫ u and ∫ arm × u.
    let mesh = &hierarchy.finest().mesh;
    let mut sums = [[0.0; 3]; 2];
    for (tet, vertices) in mesh.tets().iter().enumerate() {
        let values = vertices.map(|v| solved.solution.values[v as usize]);
        for (point, weight) in quadrature::DEGREE_2 {
            let v = weight * mesh.volume(tet);
            let p = quadrature::position(&mesh.corners(tet), point);
            let u = quadrature::position(&values, point);
            let arm = [p[0] - 1.0, p[1] - 0.5, p[2] - 0.5];
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                sums[0][k] += v * u[k];
                sums[1][k] += v * (arm[i] * u[j] - arm[j] * u[i]);
            }
        }
    }
    assert!(sums.as_flattened().iter().all(|sum| sum.abs() < 1e-12), "{sums:?}");
}

#[test]
fn a_body_on_rollers_is_free_in_their_plane_alone() {
    // Pressed on z = 0 with 5 a unit of area, pushed along x with 2: σ_zz = −5, and the push
    // is taken by inertia.
    let hierarchy = refined(kuhn_box([2, 2, 2], [2.0, 1.0, 1.0]), 1);
    let problem = Elasticity {
        traction: vec![(6, vector([0.0, 0.0, -5.0])), (2, vector([2.0, 0.0, 0.0]))],
        supports: vec![Support { surface: 5, held: Held::Normal(1e4.into()) }],
        free: Free::Balance,
        ..Elasticity::new(Material::new(100.0, 0.0))
    };
    let refused = Elasticity { free: Free::Refuse, ..problem.clone() };
    let refused = Discretisation::new(&hierarchy, &refused, &options()[0]).err().unwrap();
    assert!(refused.to_string().contains("free = \"balance\""), "{refused}");
    for options in options() {
        let solved = solve(&hierarchy, &problem, &options);
        let (stress, forces) = stress_and_forces(&hierarchy, &problem, &solved);
        assert!(stress.iter().all(|stress| (stress[2] + 5.0).abs() < 0.5));
        let [x, y, z] = forces.supports[0];
        assert!(x.abs() < 1e-9 && y.abs() < 1e-9 && (z - 10.0).abs() < 1e-6, "{forces:?}");
        assert!((forces.inertia[0] + 2.0).abs() < 1e-9 && forces.imbalance() < 1e-8);
        let free = solved.discrete.free.as_ref().unwrap();
        assert_eq!(free.null_space.dimension(), 3);
        // The foot is moved by its outward normal, that is down.
        let feet = solved.solution.values.iter().zip(hierarchy.finest().mesh.points());
        let mut feet = feet.filter(|(_, p)| p[2] == 0.0);
        assert!(feet.all(|(u, _)| (u[2] + 1e4).abs() < 1e-8));
    }
}

#[test]
fn each_part_has_its_own_motions() {
    let hierarchy = refined(both(kuhn_cube(1), &kuhn_cube(1), [3.0, 0.0, 0.0]), 2);
    let pull = |side: i32, t: f64| (side, vector([t, 0.0, 0.0]));
    let problem = Elasticity {
        traction: vec![pull(1, -1.0), pull(2, 1.0), pull(11, -7.0), pull(12, 7.0)],
        free: Free::Balance,
        ..Elasticity::new(Material::new(10.0, 0.25))
    };
    let solved = solve(&hierarchy, &problem, &options()[0]);
    let (stress, _) = stress_and_forces(&hierarchy, &problem, &solved);
    for (tet, stress) in stress.iter().enumerate() {
        let exact = if hierarchy.finest().mesh.corners(tet)[0][0] > 2.0 { 7.0 } else { 1.0 };
        assert!((stress[0] - exact).abs() < 1e-7, "{stress:?}");
    }
    assert_eq!(solved.discrete.free.unwrap().null_space.dimension(), 12);
}

#[test]
fn bits_do_not_depend_on_the_number_of_threads() {
    let hierarchy = refined(kuhn_box([4, 3, 3], [2.0, 1.0, 1.0]), 2);
    let problem = bar([1.0, 3.0], 2.0, 0.3);
    let solutions = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| solve(&hierarchy, &problem, &Options::default()).solution.values)
    });
    assert!(solutions.iter().all(|values| *values == solutions[0]));
}
