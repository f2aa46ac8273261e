//! Levels below the input mesh: any mesh is solved on, refined or not.

mod bodies;

use bodies::{checked, uneven_box};
use octruss_fem::*;
use octruss_mesh::shapes::kuhn_box;
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, TetMesh};
use octruss_solver::*;

fn clamp(surface: i32) -> Support {
    Support { surface, held: Held::Components([0, 1, 2].map(|_| Some(0.0.into()))) }
}

/// Clamped at x = 0, pulled and sheared at the other end.
fn cantilever(young: ByRegion<Material>) -> Elasticity {
    let traction = vec![(2, vector([1.0, 0.3, -0.2]))];
    Elasticity { supports: vec![clamp(1)], traction, ..Elasticity::new(young) }
}

fn heated() -> Poisson {
    Poisson { source: 1.0.into(), fixed: vec![(1, 0.0.into())], ..Poisson::default() }
}

fn hierarchy(mesh: TetMesh, levels: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    (0..levels).for_each(|_| hierarchy.subdivide(Scheme::Linear).unwrap());
    hierarchy
}

/// The solution and how many levels were given and made.
fn solved<P: Problem>(hierarchy: &Hierarchy, problem: &P) -> (Solution<P::Entry>, [usize; 2]) {
    let options = Options { prolongation: Some(Scheme::Linear.into()), ..Options::default() };
    let discretised = Discretisation::new(hierarchy, problem, &options).unwrap();
    let mut solver = discretised.solver(&options).unwrap();
    let count = |origin| solver.multigrid.levels().iter().filter(|l| l.origin == origin).count();
    let counts = [LevelOrigin::Given, LevelOrigin::Algebraic].map(count);
    (solver.solve(None).unwrap(), counts)
}

#[test]
fn iterations_hardly_grow_on_larger_meshes() {
    let meshes = [12, 20, 32].map(|n| hierarchy(uneven_box([n; 3], [1.0; 3]), 0));
    let counts = meshes.each_ref().map(|mesh| {
        let (elastic, [given, made]) = solved(mesh, &cantilever(Material::new(1.0, 0.3).into()));
        assert!(given == 1 && made > 0);
        [elastic.report.iterations, solved(mesh, &heated()).0.report.iterations]
    });
    let [[small, _], _, [elastic, heat]] = counts;
    assert!(elastic <= small + 4 && elastic <= 24 && heat <= 14, "{counts:?}");
}

#[test]
fn geometric_levels_stay_what_they_are() {
    let body = hierarchy(uneven_box([16; 3], [1.0; 3]), 1);
    let (elastic, [given, made]) = solved(&body, &cantilever(Material::new(1.0, 0.3).into()));
    assert!(given == 2 && made > 0);
    assert!(elastic.report.iterations <= 25, "{}", elastic.report.iterations);
}

#[test]
fn one_level_of_a_cube_balances_its_loads() {
    let body = hierarchy(kuhn_box([20; 3], [1.0; 3]), 0);
    let problem = cantilever(Material::new(1.0, 0.3).into());
    let displacement = solved(&body, &problem).0.values;
    let level = body.finest();
    let (mesh, topology) = (&level.mesh, &level.topology);
    assert_eq!(mesh.points().len(), 9_261);
    let stresses = stresses(mesh, &problem, &strains(mesh, &displacement).unwrap()).unwrap();
    let constraints = Constraints::new(mesh, topology, &problem.supports).unwrap();
    let forces =
        Forces::new((mesh, topology), &problem, &constraints, &displacement, &stresses).unwrap();
    for (reaction, load) in forces.supports[0].iter().zip([1.0, 0.3, -0.2]) {
        assert!((reaction + load).abs() < 1e-7, "{:?}", forces.supports);
    }
}

#[test]
fn materials_parts_and_lone_vertices_need_nothing_special() {
    // Two bars apart from each other, each of a soft and a hard half, and a triangle that
    // stands free.
    let bar = uneven_box([24, 8, 8], [3.0, 1.0, 1.0]).into_raw();
    let mut raw = bar.clone();
    let shift = bar.points.len() as u32;
    raw.points.extend(bar.points.iter().map(|[x, y, z]| [*x, y + 5.0, *z]));
    raw.tets.extend(bar.tets.iter().map(|tet| tet.map(|v| v + shift)));
    for (triangle, tag) in bar.triangles.simplices.iter().zip(&bar.triangles.tags) {
        raw.triangles.push(triangle.map(|v| v + shift), *tag);
    }
    let lone = raw.points.len() as u32;
    raw.points.extend([[9.0, 9.0, 9.0], [8.0, 9.0, 9.0], [9.0, 8.0, 9.0]]);
    raw.triangles.push([lone, lone + 1, lone + 2], 99);
    let is_hard = |tet: &[u32; 4]| tet.iter().all(|v| raw.points[*v as usize][0] >= 1.5 - 1e-9);
    raw.regions = raw.tets.iter().map(|tet| i32::from(is_hard(tet))).collect();
    let body = hierarchy(checked(raw), 0);
    let hard = vec![(1, Material::new(1e3, 0.3))];
    let materials = ByRegion { default: Material::new(1.0, 0.3), regions: hard };
    let (elastic, _) = solved(&body, &cantilever(materials));
    assert!(elastic.report.iterations <= 30, "{}", elastic.report.iterations);
    // The same of both.
    for (one, other) in
        elastic.values[..shift as usize].iter().zip(&elastic.values[shift as usize..])
    {
        assert!((0..3).all(|k| (one[k] - other[k]).abs() < 1e-5), "{one:?} {other:?}");
    }
    assert_eq!(elastic.values[lone as usize], [0.0; 3]);
}

#[test]
fn oblique_supports_are_respected_on_all_levels() {
    // A cube turned by 30° about z slides on three of its sides.
    let (sin, cos) = (30f64.to_radians()).sin_cos();
    let mut raw = kuhn_box([14; 3], [1.0; 3]).into_raw();
    raw.points
        .iter_mut()
        .for_each(|p| *p = [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1], p[2]]);
    let body = hierarchy(checked(raw), 0);
    let pull = [cos, sin, 0.0];
    let slide = |surface| Support { surface, held: Held::Normal(0.0.into()) };
    let problem = Elasticity {
        supports: [1, 3, 5].map(slide).into(),
        traction: vec![(2, vector(pull))],
        ..Elasticity::new(Material::new(1.0, 0.25))
    };
    let (solution, [_, made]) = solved(&body, &problem);
    assert!(made > 0 && solution.report.iterations <= 25, "{}", solution.report.iterations);
    // Stretched by 1 / E along the pull, ν / E across.
    for (u, p) in solution.values.iter().zip(body.finest().mesh.points()) {
        let [along, across] = [cos * p[0] + sin * p[1], cos * p[1] - sin * p[0]];
        let expected = [cos * along + sin * 0.25 * across, sin * along - cos * 0.25 * across];
        assert!((u[0] - expected[0]).abs() < 1e-6 && (u[1] - expected[1]).abs() < 1e-6);
        assert!((u[2] + 0.25 * p[2]).abs() < 1e-6);
    }
}

#[test]
fn the_same_bits_for_any_number_of_threads() {
    let body = hierarchy(uneven_box([18; 3], [1.0; 3]), 0);
    let solutions = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let problem = cantilever(Material::new(1.0, 0.3).into());
            (solved(&body, &problem).0.values, solved(&body, &heated()).0.values)
        })
    });
    assert!(solutions[0] == solutions[1] && solutions[0] == solutions[2]);
}

#[test]
fn an_updated_multigrid_makes_its_algebraic_levels_anew() {
    let body = hierarchy(uneven_box([24; 3], [1.0; 3]), 0);
    let options = Options { prolongation: Some(Scheme::Linear.into()), ..Options::default() };
    let discretised = |hard: f64| {
        let young = Scalar::function(move |[x, ..]: [f64; 3]| if x > 0.4 { hard } else { 1.0 });
        let problem = Poisson { coefficient: young.into(), ..heated() };
        Discretisation::new(&body, &problem, &options).unwrap()
    };
    let [soft, hard] = [1.0, 300.0].map(discretised);
    let applied = |mut multigrid: Multigrid| {
        assert!(multigrid.levels().iter().any(|level| level.origin == LevelOrigin::Algebraic));
        let mut z = vec![0.0; hard.matrix.rows()];
        multigrid.apply(&noise(hard.matrix.rows(), 14), &mut z);
        (z, multigrid.levels().to_vec())
    };
    let made = |discretised: &Discretisation| discretised.solver(&options).unwrap().multigrid;
    assert_eq!(applied(made(&soft).updated(&hard.matrix).unwrap()), applied(made(&hard)));
}

#[test]
fn a_coarsest_mesh_without_unknowns_is_passed_over() {
    let body = hierarchy(kuhn_box([1, 1, 1], [1.0; 3]), 2);
    let problem = Elasticity {
        supports: vec![clamp(1), clamp(2)],
        body_force: vector([0.0, 0.0, -1.0]).into(),
        ..Elasticity::new(Material::new(1.0, 0.3))
    };
    let (solution, [given, _]) = solved(&body, &problem);
    assert_eq!(given, 2);
    assert!(solution.report.iterations > 0);
}

#[test]
fn full_multigrid_finds_a_good_start_above_algebraic_levels() {
    let body = hierarchy(uneven_box([16; 3], [1.0; 3]), 1);
    let problem = cantilever(Material::new(1.0, 0.3).into());
    let solved = |cycle| {
        let options = Options { cycle, ..Options::default() };
        Discretisation::new(&body, &problem, &options).unwrap().solve(&options).unwrap()
    };
    let [plain, full] = [None, Some(Cycle::Full)].map(solved);
    assert!(full.report.iterations + 2 <= plain.report.iterations);
}
