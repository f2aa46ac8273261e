//! Well-posed, but ill-conditioned: what holds a body is billions of times softer than the
//! body itself. Closed forms are the judges; of a contrast c rounding leaves 10 ε c.

use octruss_fem::*;
use octruss_mesh::shapes::{kuhn_box, kuhn_cube};
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, check};

/// The sides of the unit cube.
const X0: i32 = 1;
const X1: i32 = 2;
const Y0: i32 = 3;

fn hierarchy() -> Hierarchy {
    let mut hierarchy = Hierarchy::new(kuhn_cube(1), &FeatureOptions::default());
    (0..2).for_each(|_| hierarchy.subdivide(Scheme::Linear).unwrap());
    let mesh = hierarchy.finest().mesh.raw();
    for (side, axis, at) in [(X0, 0, 0.0), (X1, 0, 1.0), (Y0, 1, 0.0)] {
        let triangles = mesh.triangles.simplices.iter().zip(&mesh.triangles.tags);
        let vertices =
            triangles.filter(|(_, tag)| **tag == side).flat_map(|(vertices, _)| vertices);
        assert!(vertices.into_iter().all(|&v| mesh.points[v as usize][axis] == at));
    }
    hierarchy
}

fn allowed(contrast: f64) -> f64 {
    f64::max(1e-6, 10.0 * f64::EPSILON * contrast)
}

#[test]
fn a_cube_on_soft_springs_is_stretched_by_one_over_its_modulus() {
    let hierarchy = hierarchy();
    let young = 210e3;
    for stiffness in [1e-2, 1e-3, 1e-6] {
        let soft = [0, 1, 2].map(|_| stiffness.into());
        let problem = Elasticity {
            springs: vec![(Y0, Stiffness::Axes(soft))],
            traction: vec![(X0, vector([-1.0, 0.0, 0.0])), (X1, vector([1.0, 0.0, 0.0]))],
            ..Elasticity::new(Material::new(young, 0.3))
        };
        let options = Options { prolongation: Some(Scheme::Linear.into()), ..Options::default() };
        let cube = Discretisation::new(&hierarchy, &problem, &options).unwrap();
        let u = cube.solve(&options).unwrap().values;
        let points = hierarchy.finest().mesh.points();
        let mean = |x: f64| {
            let side: Vec<f64> =
                (0..u.len()).filter(|&v| points[v][0] == x).map(|v| u[v][0]).collect();
            side.iter().sum::<f64>() / side.len() as f64
        };
        let error = (young * (mean(1.0) - mean(0.0)) - 1.0).abs();
        assert!(error <= allowed(young / stiffness), "springs of {stiffness}: {error}");
    }
}

#[test]
fn heat_that_leaves_through_a_weak_film_warms_the_body_by_flux_over_coefficient() {
    let hierarchy = hierarchy();
    let (conductivity, flux) = (150.0, 1e-5);
    for film in [1e-3, 1e-6, 1.5e-8] {
        let robin = Robin { coefficient: film.into(), value: 20.0.into() };
        let problem = Poisson {
            coefficient: conductivity.into(),
            robin: vec![(X0, robin)],
            flux: vec![(X1, flux.into())],
            ..Poisson::default()
        };
        let options = Options::default();
        let cube = Discretisation::new(&hierarchy, &problem, &options).unwrap();
        let u = cube.solve(&options).unwrap().values;
        let warmed = flux / film;
        let points = hierarchy.finest().mesh.points();
        for v in (0..u.len()).filter(|&v| points[v][0] == 0.0) {
            let error = (u[v] - 20.0 - warmed).abs() / (20.0 + warmed);
            // Each row loses some of the flux to rounding, on a lattice all of them alike.
            let rounding = u.len() as f64 * f64::EPSILON * conductivity / film;
            assert!(error <= f64::max(1e-6, 0.25 * rounding), "film of {film}: {error}");
        }
    }
}

#[test]
fn what_rounding_leaves_free_is_named() {
    // The upper half hangs on a layer that is 10²⁰ times softer.
    let mesh = kuhn_box([2, 2, 6], [1.0, 1.0, 3.0]);
    let mut raw = mesh.into_raw();
    let height = |tet: &[u32; 4]| tet.iter().map(|v| raw.points[*v as usize][2]).sum::<f64>() / 4.0;
    raw.regions = raw.tets.iter().map(|tet| (height(tet) / 0.5).floor() as i32 / 2).collect();
    let mesh = check(raw, &Default::default()).unwrap().mesh;
    let hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    let soft = vec![(1, Material::new(1e-20, 0.3))];
    let problem = Elasticity {
        supports: vec![Support { surface: 5, held: Held::displacement([0.0; 3]) }],
        traction: vec![(6, vector([0.0, 0.0, 1.0]))],
        ..Elasticity::new(ByRegion { default: Material::new(1.0, 0.3), regions: soft })
    };
    let options = Options::default();
    let refused = Discretisation::new(&hierarchy, &problem, &options).unwrap().solve(&options);
    let Err(Error::LostToRounding { vertices, regions, motion, .. }) = &refused else {
        panic!("{refused:?}")
    };
    assert_eq!((*vertices, &**regions), (27, "region 2"), "{refused:?}");
    assert!(["translation", "rotation", "screw"].iter().any(|word| motion.contains(word)));

    let coefficient = ByRegion { default: 1.0.into(), regions: vec![(1, 1e-20.into())] };
    let problem = Poisson {
        coefficient,
        fixed: vec![(5, 0.0.into())],
        source: 1.0.into(),
        ..Poisson::default()
    };
    let refused = Discretisation::new(&hierarchy, &problem, &options).unwrap().solve(&options);
    let Err(Error::LostToRounding { regions, motion, .. }) = &refused else {
        panic!("{refused:?}")
    };
    assert!(regions == "region 2" && motion.contains("constant"), "{regions}: {motion}");
}
