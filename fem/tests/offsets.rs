//! Values prescribed far from zero: temperatures of a million, displacements of a thousand.
//! What is added to all of them, a constant or a rigid motion, is found again in the
//! solution, and what is left of that has the digits that it has without.

use octruss_fem::*;
use octruss_mesh::shapes::{kuhn_box, kuhn_cube};
use octruss_mesh::{FeatureOptions, Hierarchy, RawMesh, Scheme, TetMesh, check};

const OFFSETS: [f64; 5] = [0.0, 1.0, 1e3, 1e6, -1e6];

fn refined(mesh: TetMesh) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    (0..2).for_each(|_| hierarchy.subdivide(Scheme::Linear).unwrap());
    hierarchy
}

/// With and without full multigrid, with and without re-assembled coarse matrices.
fn options() -> [Options; 3] {
    let tight = Options { tolerance: 1e-10, ..Options::default() };
    [
        tight,
        Options { cycle: Some(Cycle::Full), ..tight },
        Options { coarse_operator: CoarseOperator::Reassembled, ..tight },
    ]
}

fn solve<P: Problem>(hierarchy: &Hierarchy, problem: &P, options: &Options) -> Solution<P::Entry> {
    Discretisation::new(hierarchy, problem, options).unwrap().solve(options).unwrap()
}

/// The largest difference of two lists of numbers relative to the largest number.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let largest = b.iter().map(|b| b.abs()).fold(0.0, f64::max);
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
}

/// Values less their mean.
fn levelled(values: &[f64]) -> Vec<f64> {
    let first = values[0];
    let mean = values.iter().map(|v| v - first).sum::<f64>() / values.len() as f64;
    values.iter().map(|value| value - first - mean).collect()
}

/// Checks the solutions of a scalar problem with each offset against that without.
fn check_scalar<P: Problem<Entry = f64>>(mesh: TetMesh, problem: impl Fn(f64) -> P) {
    let hierarchy = refined(mesh);
    for options in options() {
        let level = solve(&hierarchy, &problem(0.0), &options);
        let expected = levelled(&level.values);
        for offset in OFFSETS {
            let solution = solve(&hierarchy, &problem(offset), &options);
            let differences = levelled(solution.differences());
            let error = distance(&differences, &expected);
            assert!(error < 1e-8, "{offset}: {error:e}");
            let shifted: Vec<f64> = level.values.iter().map(|value| value + offset).collect();
            let error = distance(&solution.values, &shifted);
            assert!(error < 1e-8, "{offset}: {error:e}");
            let iterations = solution.report.iterations;
            assert!(iterations <= level.report.iterations + 1, "{offset}: {iterations}");
        }
    }
}

fn around(offset: f64) -> Scalar {
    Scalar::function(move |[x, y, z]| offset + 0.01 * (x - y * z))
}

#[test]
fn a_temperature_scale_does_not_matter_where_values_are_fixed() {
    check_scalar(kuhn_cube(2), |offset| Poisson {
        source: 0.1.into(),
        fixed: vec![(1, around(offset)), (2, (offset + 0.02).into())],
        ..Poisson::default()
    });
}

#[test]
fn a_temperature_scale_does_not_matter_where_a_surrounding_cools() {
    let robin = |value: Scalar| Robin { coefficient: Scalar::function(|[x, ..]| 0.5 + x), value };
    check_scalar(kuhn_cube(2), |offset| Poisson {
        source: 0.1.into(),
        robin: vec![(1, robin(around(offset))), (4, robin(offset.into()))],
        ..Poisson::default()
    });
    check_scalar(kuhn_cube(2), |offset| Poisson {
        flux: vec![(6, 0.3.into())],
        fixed: vec![(2, offset.into())],
        robin: vec![(1, robin(around(offset)))],
        ..Poisson::default()
    });
}

#[test]
fn an_offset_does_not_matter_to_a_biharmonic_function() {
    check_scalar(kuhn_cube(2), |offset| Biharmonic {
        source: 0.5.into(),
        fixed: vec![(1, around(offset)), (2, offset.into())],
    });
}

#[test]
fn one_prescribed_constant_leaves_the_bits_of_the_difference_alone() {
    let hierarchy = refined(kuhn_cube(2));
    let problem = |offset: f64| Poisson {
        source: 0.1.into(),
        fixed: vec![(1, offset.into()), (3, offset.into())],
        ..Poisson::default()
    };
    let [level, shifted] =
        [0.0, 293.15].map(|offset| solve(&hierarchy, &problem(offset), &Options::default()));
    assert!(level.difference.is_none());
    assert_eq!(level.values, shifted.differences());
    let fixed = shifted.values.iter().zip(hierarchy.finest().mesh.points());
    let fixed = fixed.filter(|(_, point)| point[0] == 0.0).map(|(value, _)| *value);
    assert!(fixed.into_iter().all(|value| value == 293.15));
}

#[test]
fn where_prescribed_values_vary_as_much_as_they_are_nothing_changes() {
    let hierarchy = refined(kuhn_cube(1));
    let problem = Poisson { fixed: vec![(1, 0.0.into()), (2, 1.0.into())], ..Poisson::default() };
    let discrete = Discretisation::new(&hierarchy, &problem, &Options::default()).unwrap();
    assert!(discrete.difference.is_none());
}

/// A mesh and another beside it.
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

#[test]
fn each_part_of_a_body_has_its_own_constant() {
    let mesh = || both(kuhn_cube(1), &kuhn_cube(1), [3.0, 0.0, 0.0]);
    let hierarchy = refined(mesh());
    let problem = |offsets: [f64; 2]| Poisson {
        source: 0.1.into(),
        fixed: vec![(1, around(offsets[0])), (11, around(offsets[1]))],
        ..Poisson::default()
    };
    let half = hierarchy.finest().mesh.points().iter().map(|p| p[0] < 2.0);
    let side = |values: &[f64], which: bool| -> Vec<f64> {
        let mine = values.iter().zip(half.clone()).filter(|(_, left)| *left == which);
        levelled(&mine.map(|(value, _)| *value).collect::<Vec<_>>())
    };
    let options = Options { tolerance: 1e-10, ..Options::default() };
    let level = solve(&hierarchy, &problem([0.0, 0.0]), &options);
    let apart = solve(&hierarchy, &problem([1e6, -300.0]), &options);
    for which in [true, false] {
        let error = distance(&side(apart.differences(), which), &side(&level.values, which));
        assert!(error < 1e-7, "{error:e}");
    }
}

/// A rigid motion of this size: along (1, −2, 0.5), or about (1, 2, 3).
fn rigid(kind: usize, size: f64) -> impl Fn([f64; 3]) -> [f64; 3] + Copy {
    move |[x, y, z]| match kind {
        0 => [size, -2.0 * size, 0.5 * size],
        _ => [size * (2.0 * z - 3.0 * y), size * (3.0 * x - z), size * (y - 2.0 * x)],
    }
}

/// The tensors of a bar of which one end is held and the other twisted and pulled, after a
/// rigid motion, and what its supports and springs do.
fn deformed(
    hierarchy: &Hierarchy,
    moved: impl Fn([f64; 3]) -> [f64; 3] + Copy + Send + Sync + 'static,
    options: &Options,
) -> (Vec<f64>, Forces) {
    let end = move |[x, y, z]: [f64; 3]| {
        let moved = moved([x, y, z]);
        [moved[0] + 1e-3 * x, moved[1] + 2e-3 * x * z, moved[2] - 1e-3 * x * y]
    };
    let component = |k: usize| Some(Scalar::function(move |p| end(p)[k]));
    let along = Held::Components([component(0), None, None]);
    let normal = Held::Normal(Scalar::function(move |p| -end(p)[1]));
    let problem = Elasticity {
        traction: vec![(6, vector([0.0, 0.02, 0.3]))],
        supports: vec![
            Support { surface: 3, held: normal },
            Support { surface: 2, held: along },
            Support { surface: 1, held: Held::Components([0, 1, 2].map(component)) },
        ],
        ..Elasticity::new(Material::new(100.0, 0.3))
    };
    let discrete = Discretisation::new(hierarchy, &problem, options).unwrap();
    let solution = discrete.solve(options).unwrap();
    let level = hierarchy.finest();
    let strain = strains(&level.mesh, solution.differences()).unwrap();
    let stress = stresses(&level.mesh, &problem, &strain).unwrap();
    let forces = Forces::new(
        (&level.mesh, &level.topology),
        &problem,
        &discrete.constraints,
        &solution.values,
        &stress,
    );
    (stress.as_flattened().to_vec(), forces.unwrap())
}

#[test]
fn a_rigid_motion_of_all_supports_does_not_stress_a_body() {
    let hierarchy = refined(kuhn_box([4, 2, 2], [2.0, 1.0, 1.0]));
    for options in options() {
        let (stress, forces) = deformed(&hierarchy, rigid(0, 0.0), &options);
        for (kind, size) in [0, 1].into_iter().flat_map(|kind| OFFSETS.map(|size| (kind, size))) {
            let (moved, moved_forces) = deformed(&hierarchy, rigid(kind, size), &options);
            // 1e-16 of 1e6 beside displacements of 1e-3, over an edge of 1/8.
            let error = distance(&moved, &stress);
            assert!(error < 1e-6, "{kind} {size}: {error:e}");
            let supports = [&forces, &moved_forces].map(|f| f.supports.as_flattened().to_vec());
            let error = distance(&supports[1], &supports[0]);
            assert!(error < 1e-6, "{kind} {size}: {error:e}");
            assert!(moved_forces.imbalance() < 1e-6, "{}", moved_forces.imbalance());
        }
    }
}

#[test]
fn a_body_that_is_moved_as_it_is_stays_free_of_stress() {
    let hierarchy = refined(kuhn_box([2, 1, 1], [2.0, 1.0, 1.0]));
    for (kind, size) in [0, 1].into_iter().flat_map(|kind| [1.0, 1e6].map(|size| (kind, size))) {
        let motion = rigid(kind, size);
        let component = |k: usize| Some(Scalar::function(move |p| motion(p)[k]));
        let held = Held::Components([0, 1, 2].map(component));
        let problem = Elasticity {
            supports: vec![Support { surface: 1, held }],
            ..Elasticity::new(Material::new(100.0, 0.3))
        };
        let solution = solve(&hierarchy, &problem, &Options::default());
        assert!(solution.differences().iter().all(|u| *u == [0.0; 3]), "{kind} {size}");
        let exact: Vec<_> = hierarchy.finest().mesh.points().iter().map(|p| motion(*p)).collect();
        assert!(distance(solution.values.as_flattened(), exact.as_flattened()) < 1e-14);
    }
}

#[test]
fn springs_pull_back_from_a_rigid_motion() {
    // A block pushed up by 1000 + 1e-3 below springs of stiffness 2 an area of 1: they hold
    // against it with 2 (1000 + 1e-3 + shortening), of which the block of length 1 and
    // E = 1e6 gives way by that over 1e6.
    let hierarchy = refined(kuhn_cube(2));
    let problem = Elasticity {
        springs: vec![(6, Stiffness::Axes(vector([0.0, 0.0, 2.0])))],
        supports: vec![Support { surface: 5, held: Held::displacement([0.0, 0.0, 1000.001]) }],
        ..Elasticity::new(Material::new(1e6, 0.0))
    };
    let options = Options { tolerance: 1e-12, ..Options::default() };
    let solution = solve(&hierarchy, &problem, &options);
    let force = 2.0 * 1000.001 / (1.0 + 2.0 / 1e6);
    for (u, p) in solution.values.iter().zip(hierarchy.finest().mesh.points()) {
        assert!((u[2] - (1000.001 - force / 1e6 * p[2])).abs() < 1e-10, "{u:?} at {p:?}");
    }
}
