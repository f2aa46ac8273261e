//! Elastic bodies under loads and supports whose deformation and reactions are
//! derived by hand; what is refused; extreme units and any number of threads.

mod bodies;

use bodies::{affine_support, assert_near, checked, sliding, solve, uneven_box};
use octruss_fem::Error;
use octruss_fem::*;
use octruss_mesh::shapes::{kuhn_box, kuhn_cube};
use octruss_mesh::{TetMesh, Topology};

fn forces(mesh: &TetMesh, problem: &Elasticity) -> (Vec<[f64; 3]>, Vec<[f64; 6]>, Forces) {
    let topology = Topology::new(mesh.raw());
    let system = assemble_elasticity(mesh, &topology, problem).unwrap();
    let u = bodies::solve_system(&system);
    let stress = stresses(mesh, problem, &strains(mesh, &u).unwrap()).unwrap();
    let forces = Forces::new((mesh, &topology), problem, &system.constraints, &u, &stress).unwrap();
    (u, stress, forces)
}

fn assert_force(found: [f64; 3], exact: [f64; 3]) {
    assert_near(&[found], |_| exact, 1e-9);
}

#[test]
fn a_column_under_its_weight_stands_on_its_base() {
    // ρ g = 2 · 3 on a column of height 4 and area 2, E = 8, ν = 0, held from
    // below: u_z = −(ρ g / E) (H z − z² / 2), exact at vertices in one dimension,
    // here up to the tets' own error. The base carries the weight of 48.
    let mesh = kuhn_box([2, 2, 16], [1.0, 2.0, 4.0]);
    let problem = Elasticity {
        gravity: vector([0.0, 0.0, -3.0]),
        supports: sliding(&[1, 2, 3, 4, 5]),
        ..Elasticity::new(Material { density: 2.0.into(), ..Material::new(8.0, 0.0) })
    };
    let (u, stress, forces) = forces(&mesh, &problem);
    assert_force(forces.loads, [0.0, 0.0, -48.0]);
    assert_force(forces.supports[4], [0.0, 0.0, 48.0]);
    assert!(forces.imbalance() < 1e-9);
    for (u, [_, _, z]) in u.iter().zip(mesh.points()) {
        let exact = -0.75 * (4.0 * z - 0.5 * z * z);
        assert!((u[2] - exact).abs() < 0.01 * 6.0, "{} for {exact}", u[2]);
    }
    for (tet, stress) in stress.iter().enumerate() {
        let height = mesh.corners(tet).iter().map(|p| p[2]).sum::<f64>() / 4.0;
        assert!((stress[2] + 6.0 * (4.0 - height)).abs() < 1.0, "{stress:?} at {height}");
    }
}

#[test]
fn a_pulled_bar_of_two_materials_stretches_in_series() {
    // ν = 0, traction 6 on x = 2; E = 3 for x < 1, else 12: u(1) = 2, u(2) = 2.5.
    // Stress is 6 everywhere, strain jumps from 2 to 1/2.
    let mut raw = uneven_box([4, 2, 2], [2.0, 1.0, 1.0]).into_raw();
    // The plane x = 1 stays plane.
    let straight = kuhn_box([4, 2, 2], [2.0, 1.0, 1.0]);
    for (point, plain) in raw.points.iter_mut().zip(straight.points()) {
        if plain[0] == 1.0 {
            point[0] = 1.0;
        }
    }
    for (tet, region) in raw.tets.iter().zip(&mut raw.regions) {
        let is_left = tet.iter().map(|&v| raw.points[v as usize][0]).sum::<f64>() < 4.0;
        *region = if is_left { 1 } else { 2 };
    }
    let mesh = checked(raw);
    let mut material = ByRegion::from(Material::new(3.0, 0.0));
    material.regions.push((2, Material::new(12.0, 0.0)));
    let problem = Elasticity {
        traction: vec![(2, vector([6.0, 0.0, 0.0]))],
        supports: sliding(&[1, 3, 5]),
        ..Elasticity::new(material)
    };
    let (u, stress, forces) = forces(&mesh, &problem);
    let exact = |v: usize| {
        let x = mesh.points()[v][0];
        [if x < 1.0 { 2.0 * x } else { 2.0 + 0.5 * (x - 1.0) }, 0.0, 0.0]
    };
    assert_near(&u, exact, 1e-11);
    assert_near(&stress, |_| [6.0, 0.0, 0.0, 0.0, 0.0, 0.0], 1e-10);
    assert!(stress.iter().all(|stress| (von_mises(stress) - 6.0).abs() < 1e-10));
    assert_force(forces.supports[0], [-6.0, 0.0, 0.0]);
    assert_force(forces.loads, [6.0, 0.0, 0.0]);
    // Each side is recovered by itself.
    let strain = strains(&mesh, &u).unwrap();
    for (region, exact) in [(1, 2.0), (2, 0.5)] {
        let side = Recovery::new(&mesh, |id| id == region).at_vertices(&strain).unwrap();
        for (strain, [x, ..]) in side.iter().zip(mesh.points()) {
            let inside = if region == 1 { *x <= 1.0 } else { *x >= 1.0 };
            assert_eq!(strain[0].is_nan(), !inside);
            assert!(!inside || (strain[0] - exact).abs() < 1e-11);
        }
    }
}

#[test]
fn pressure_pushes_inward_and_closed_pressure_does_not_push_at_all() {
    // p = 5 on the side x = 1 of area 6: −30 in x, which the opposite side carries.
    let mesh = uneven_box([3, 3, 3], [1.0, 2.0, 3.0]);
    let held = |pressure| Elasticity {
        pressure,
        supports: vec![Support { surface: 1, held: Held::displacement([0.0; 3]) }],
        ..Elasticity::new(Material::new(10.0, 0.3))
    };
    let (_, _, pushed) = forces(&mesh, &held(vec![(2, 5.0.into())]));
    assert_force(pushed.loads, [-30.0, 0.0, 0.0]);
    assert_force(pushed.supports[0], [30.0, 0.0, 0.0]);
    let (_, _, closed) = forces(&mesh, &held((1..=6).map(|side| (side, 5.0.into())).collect()));
    assert_force(closed.loads, [0.0; 3]);
    // Water of weight 2 up to z = 4 lifts by the weight of what it displaces.
    let water = Scalar::function(|[_, _, z]| 2.0 * (4.0 - z));
    let (_, _, dipped) = forces(&mesh, &held((1..=6).map(|side| (side, water.clone())).collect()));
    assert_force(dipped.loads, [0.0, 0.0, 12.0]);
    assert_force(dipped.supports[0], [0.0, 0.0, -12.0]);
    assert!(dipped.imbalance() < 1e-9);
}

#[test]
fn a_block_on_springs_sinks_by_load_over_stiffness() {
    // Traction −4 on the top of a block of height 2, E = 8, ν = 0, springs of 10
    // below: u_z = −0.4 − 0.5 z. The same with springs along axes, which also hold
    // the block from sliding.
    let mesh = uneven_box([3, 3, 4], [1.0, 1.0, 2.0]);
    let normal = Stiffness::Normal(10.0.into());
    let axes = Stiffness::Axes(vector([3.0, 3.0, 10.0]));
    for (stiffness, supports) in [(normal, sliding(&[1, 3])), (axes, vec![])] {
        let problem = Elasticity {
            traction: vec![(6, vector([0.0, 0.0, -4.0]))],
            springs: vec![(5, stiffness)],
            supports,
            ..Elasticity::new(Material::new(8.0, 0.0))
        };
        let (u, _, forces) = forces(&mesh, &problem);
        assert_near(&u, |v| [0.0, 0.0, -0.4 - 0.5 * mesh.points()[v][2]], 1e-11);
        assert_force(forces.springs[0], [0.0, 0.0, 4.0]);
        assert!(forces.imbalance() < 1e-10);
    }
}

#[test]
fn reactions_balance_loads_whatever_they_are() {
    let mesh = uneven_box([4, 4, 4], [1.0, 1.0, 1.0]);
    let wave = |a: f64| Scalar::function(move |[x, y, z]| (a * x + y).sin() + a * z);
    let problem = Elasticity {
        body_force: [wave(1.0), wave(2.0), wave(-3.0)].into(),
        gravity: vector([1.0, 2.0, -9.81]),
        traction: vec![(4, [wave(5.0), 1.0.into(), wave(-1.0)])],
        pressure: vec![(6, wave(7.0))],
        springs: vec![(2, Stiffness::Normal(Scalar::function(|[x, y, _]| 1.0 + x * y)))],
        supports: vec![affine_support(1), Support { surface: 5, held: Held::Normal(0.1.into()) }],
        ..Elasticity::new(Material { density: 3.0.into(), ..Material::new(20.0, 0.3) })
    };
    let (_, _, forces) = forces(&mesh, &problem);
    assert!(forces.imbalance() < 1e-8, "{forces:?}");
    assert!(forces.supports.iter().flatten().any(|force| force.abs() > 1.0));
    // A sliding plane pushes along its normal alone.
    assert!(forces.supports[1][0].abs() + forces.supports[1][1].abs() < 1e-12);
}

#[test]
fn a_turned_body_moves_as_the_turned_solution() {
    // Planes of symmetry at skew angles, against the same planes along axes.
    let (sin, cos) = 0.7_f64.sin_cos();
    let turn = |[x, y, z]: [f64; 3]| {
        let [x, y] = [cos * x - sin * y, sin * x + cos * y];
        [x, cos * y - sin * z, sin * y + cos * z]
    };
    let straight = uneven_box([3, 3, 4], [1.0, 1.0, 2.0]);
    let mut raw = straight.raw().clone();
    raw.points.iter_mut().for_each(|point| *point = turn(*point));
    let turned = checked(raw);
    let problem = |force: [f64; 3]| Elasticity {
        traction: vec![(6, vector(force))],
        pressure: vec![(2, 2.0.into())],
        supports: sliding(&[1, 3, 5]),
        ..Elasticity::new(Material::new(10.0, 0.3))
    };
    let u = solve(&straight, &problem([0.3, 0.2, -1.0]));
    let v = solve(&turned, &problem(turn([0.3, 0.2, -1.0])));
    assert_near(&v, |vertex| turn(u[vertex]), 1e-11);
}

#[test]
fn what_can_still_move_is_named() {
    let mesh = kuhn_cube(2);
    let topology = Topology::new(mesh.raw());
    let refused = |supports: Vec<Support>| {
        let problem = Elasticity { supports, ..Elasticity::new(Material::new(1.0, 0.3)) };
        assemble_elasticity(&mesh, &topology, &problem).unwrap_err().to_string()
    };
    let nothing = refused(vec![]);
    for mode in [
        "translation along x",
        "along y",
        "along z",
        "rotation about x through",
        "about y",
        "about z",
    ] {
        assert!(nothing.contains(mode), "{nothing}");
    }
    assert!(
        nothing.starts_with("a connected part of the mesh with 27 vertices, among them vertex 0")
    );
    let sliding_on_the_floor = refused(sliding(&[5]));
    assert!(
        sliding_on_the_floor.contains(
            "rotation about z through (0.5000, 0.5000, 0.0000), translation along x, translation \
             along y; hold more of it"
        ),
        "{sliding_on_the_floor}"
    );
    assert!(refused(sliding(&[5, 6, 1, 2])).contains(": translation along y;"));
    // Springs hold, too; normal ones do not stop sliding.
    let springs = |stiffness: Stiffness| {
        let problem = Elasticity {
            springs: vec![(5, stiffness)],
            ..Elasticity::new(Material::new(1.0, 0.3))
        };
        assemble_elasticity(&mesh, &topology, &problem)
    };
    assert!(springs(Stiffness::Axes(vector([1.0; 3]))).is_ok());
    let Err(Error::RigidModes { modes, .. }) = springs(Stiffness::Normal(1.0.into())) else {
        panic!("normal springs let it slide");
    };
    assert_eq!(modes.len(), 3);
}

#[test]
fn every_part_must_be_held() {
    let mut raw = kuhn_cube(1).into_raw();
    let other = kuhn_cube(1);
    raw.points.extend(other.points().iter().map(|p| [p[0] + 5.0, p[1], p[2]]));
    raw.tets.extend(other.tets().iter().map(|tet| tet.map(|v| v + 8)));
    raw.regions.extend(other.regions());
    for (triangle, tag) in other.triangles().iter() {
        raw.triangles.push(triangle.map(|v| v + 8), tag + 10);
    }
    let mesh = checked(raw);
    let clamp = |surface| Support { surface, held: Held::displacement([0.0; 3]) };
    let problem = |supports| Elasticity { supports, ..Elasticity::new(Material::new(1.0, 0.3)) };
    let topology = Topology::new(mesh.raw());
    let refused = assemble_elasticity(&mesh, &topology, &problem(vec![clamp(1)]));
    assert!(
        matches!(refused, Err(Error::RigidModes { vertices: 8, example: 8, ref modes }) if modes.len() == 6)
    );
    assert!(assemble_elasticity(&mesh, &topology, &problem(vec![clamp(1), clamp(12)])).is_ok());
}

#[test]
fn senseless_problems_are_refused() {
    let mesh = kuhn_cube(2);
    let topology = Topology::new(mesh.raw());
    let clamp = || vec![Support { surface: 1, held: Held::displacement([0.0; 3]) }];
    let refused = |problem: Elasticity| {
        let supports = if problem.supports.is_empty() { clamp() } else { problem.supports.clone() };
        assemble_elasticity(&mesh, &topology, &Elasticity { supports, ..problem }).unwrap_err()
    };
    let steel = || Elasticity::new(Material::new(1.0, 0.3));
    for (young, poisson, what) in [
        (0.0, 0.3, "Young's modulus"),
        (f64::NAN, 0.3, "Young's modulus"),
        (1.0, 0.5, "Poisson's ratio"),
        (1.0, -1.0, "Poisson's ratio"),
    ] {
        let told = refused(Elasticity::new(Material::new(young, poisson))).to_string();
        assert!(told.starts_with(&format!("the {what} of region 0 is ")), "{told}");
    }
    let density = Material { density: (-1.0).into(), ..Material::new(1.0, 0.3) };
    assert!(matches!(
        refused(Elasticity::new(density)),
        Error::Coefficient { what: "density", .. }
    ));
    let pole = Scalar::expression("1/x", |[x, ..]| 1.0 / x);
    let told = refused(Elasticity { pressure: vec![(3, pole)], ..steel() }).to_string();
    assert!(told.starts_with("the pressure of surface 3 is `1/x` = inf at (0, 0, "), "{told}");
    let nan = [0.0.into(), f64::NAN.into(), 0.0.into()];
    let told = refused(Elasticity { body_force: nan.into(), ..steel() }).to_string();
    assert_eq!(told, "the body force of region 0 is NaN; it must be finite everywhere");
    let springs = vec![(2, Stiffness::Normal((-1.0).into()))];
    let told = refused(Elasticity { springs, ..steel() }).to_string();
    assert_eq!(told, "the stiffness of springs of surface 2 is -1; it must be 0 or more");
    let held = Held::Components([Some(f64::INFINITY.into()), None, None]);
    let supports = vec![Support { surface: 2, held }];
    assert!(matches!(
        refused(Elasticity { supports, ..steel() }),
        Error::BoundaryValue { surface: 2, .. }
    ));
    let unknown = refused(Elasticity { traction: vec![(9, vector([0.0; 3]))], ..steel() });
    assert!(matches!(unknown, Error::UnknownSurface { id: 9, .. }));
    // A surface inside has no outside.
    let mut raw = kuhn_cube(2).into_raw();
    let inner = (0..topology.faces().len()).find(|&face| !topology.is_boundary(face)).unwrap();
    raw.triangles.push(topology.faces()[inner], 40);
    let mesh = checked(raw);
    let problem = Elasticity { pressure: vec![(40, 1.0.into())], supports: clamp(), ..steel() };
    let refused = assemble_elasticity(&mesh, &topology, &problem);
    assert!(matches!(refused, Err(Error::InnerSurface { id: 40, inner: 1 })));
}

#[test]
fn units_and_great_contrasts_do_not_spoil_the_solution() {
    // The bar in series again, plain: E = e₁ for z < 1/2 and e₂ above, ν = 0,
    // traction e₁ on top: strain 1 below, e₁ / e₂ above.
    let mut raw = kuhn_cube(4).into_raw();
    for (tet, region) in raw.tets.iter().zip(&mut raw.regions) {
        let height: f64 = tet.iter().map(|&v| raw.points[v as usize][2]).sum::<f64>() / 4.0;
        *region = if height < 0.5 { 1 } else { 2 };
    }
    let mesh = checked(raw);
    for [e1, e2] in [[1e-12, 1e-12], [1e12, 1e12], [1.0, 1e6], [1e6, 1.0]] {
        let mut material = ByRegion::from(Material::new(e1, 0.0));
        material.regions.push((2, Material::new(e2, 0.0)));
        let problem = Elasticity {
            traction: vec![(6, vector([0.0, 0.0, e1]))],
            supports: sliding(&[1, 3, 5]),
            ..Elasticity::new(material)
        };
        let u = solve(&mesh, &problem);
        let top = 0.5 + 0.5 * e1 / e2;
        let exact = |v: usize| {
            let z = mesh.points()[v][2];
            [0.0, 0.0, if z < 0.5 { z } else { 0.5 + (z - 0.5) * e1 / e2 }]
        };
        assert_near(&u, exact, 1e-6 * top);
    }
}

#[test]
fn assembly_and_forces_have_the_same_bits_for_any_number_of_threads() {
    let mesh = kuhn_cube(12);
    let topology = Topology::new(mesh.raw());
    let problem = Elasticity {
        body_force: [Scalar::function(|[x, ..]| x.sin()), 1.0.into(), 0.0.into()].into(),
        gravity: vector([0.0, 0.0, -9.81]),
        pressure: vec![(2, 3.0.into())],
        springs: vec![(4, Stiffness::Normal(3.0.into()))],
        supports: vec![affine_support(5), Support { surface: 1, held: Held::Normal(0.0.into()) }],
        ..Elasticity::new(Material {
            young: Scalar::function(|[x, y, z]| 1.0 + x * y + z),
            density: 2.0.into(),
            ..Material::new(1.0, 0.3)
        })
    };
    let results = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let system = assemble_elasticity(&mesh, &topology, &problem).unwrap();
            let u = system.expand(&system.rhs).unwrap();
            let strain = strains(&mesh, &u).unwrap();
            let stress = stresses(&mesh, &problem, &strain).unwrap();
            let recovered = Recovery::new(&mesh, |_| true).at_vertices(&stress).unwrap();
            let constraints = &system.constraints;
            let forces =
                Forces::new((&mesh, &topology), &problem, constraints, &u, &stress).unwrap();
            (system.matrix, system.rhs, recovered, forces)
        })
    });
    assert!(results[0] == results[1] && results[0] == results[2]);
}
