mod bodies;
use octruss_fem::*;
use octruss_mesh::shapes::kuhn_box;
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme};
fn clamp(surface: i32) -> Support {
    Support { surface, held: Held::displacement([0.0; 3]) }
}
#[test]
fn tables() {
    let options = Options::default();
    for (levels, n) in [(0usize, 16u32), (2, 4)] {
        for aspect in [1.0, 3.0, 10.0, 30.0, 100.0] {
            let mesh = kuhn_box([n, n, n], [1.0, 1.0, 1.0 / aspect]);
            let mut h = Hierarchy::new(mesh, &FeatureOptions::default());
            (0..levels).for_each(|_| h.subdivide(Scheme::Linear).unwrap());
            let p =
                Poisson { source: 1.0.into(), fixed: vec![(1, 0.0.into())], ..Poisson::default() };
            let a = Discretisation::new(&h, &p, &options)
                .unwrap()
                .solve(&options)
                .map(|s| s.report.iterations);
            let e = Elasticity {
                supports: vec![clamp(1)],
                traction: vec![(2, vector([0.1, 0.0, 1e-3]))],
                ..Elasticity::new(Material::new(1.0, 0.3))
            };
            let b = Discretisation::new(&h, &e, &options)
                .unwrap()
                .solve(&options)
                .map(|s| (s.report.iterations, s.report.ended));
            println!(
                "TABLE stretch {aspect} levels {levels}: {:?} {:?}",
                a.map_err(|e| e.to_string()),
                b.map_err(|e| e.to_string())
            );
        }
        for nu in [0.0, 0.3, 0.4, 0.45, 0.49, 0.499, 0.4999] {
            let mut h = Hierarchy::new(kuhn_box([n, n, n], [1.0; 3]), &FeatureOptions::default());
            (0..levels).for_each(|_| h.subdivide(Scheme::Linear).unwrap());
            let e = Elasticity {
                supports: vec![clamp(1)],
                traction: vec![(2, vector([0.1, 0.0, 0.1]))],
                ..Elasticity::new(Material::new(1.0, nu))
            };
            let b = Discretisation::new(&h, &e, &options)
                .unwrap()
                .solve(&options)
                .map(|s| (s.report.iterations, s.report.ended));
            println!("TABLE nu {nu} levels {levels}: {:?}", b.map_err(|e| e.to_string()));
        }
        for power in [-12, -9, -6, -3, 0, 3, 6, 9, 12] {
            let mut raw = kuhn_box([n, n, n], [1.0; 3]).into_raw();
            let mid = |t: &[u32; 4]| -> [f64; 3] {
                std::array::from_fn(|k| {
                    t.iter().map(|v| raw.points[*v as usize][k]).sum::<f64>() / 4.0
                })
            };
            raw.regions = raw
                .tets
                .iter()
                .map(|t| i32::from(mid(t).iter().all(|x| (0.25..0.75).contains(x))))
                .collect();
            let mut h = Hierarchy::new(bodies::checked(raw), &FeatureOptions::default());
            (0..levels).for_each(|_| h.subdivide(Scheme::Linear).unwrap());
            let c = 10f64.powi(power);
            let e = Elasticity {
                supports: vec![clamp(1)],
                traction: vec![(2, vector([0.1, 0.0, 0.1]))],
                ..Elasticity::new(ByRegion {
                    default: Material::new(1.0, 0.3),
                    regions: vec![(1, Material::new(c, 0.3))],
                })
            };
            let b = Discretisation::new(&h, &e, &options).unwrap().solve(&options).map(|s| {
                (
                    s.report.iterations,
                    s.report.ended,
                    s.report.relative_residual,
                    s.report.energy_error,
                )
            });
            println!(
                "TABLE contrast 1e{power} levels {levels}: {:?}",
                b.map_err(|e| e.to_string())
            );
        }
    }
    for (slenderness, levels) in [
        (30u32, 0),
        (30, 1),
        (30, 2),
        (30, 3),
        (100, 0),
        (100, 1),
        (100, 2),
        (200, 0),
        (200, 1),
        (200, 2),
    ] {
        let mut h = Hierarchy::new(
            kuhn_box([slenderness, 1, 1], [f64::from(slenderness), 1.0, 1.0]),
            &FeatureOptions::default(),
        );
        (0..levels).for_each(|_| h.subdivide(Scheme::Linear).unwrap());
        let e = Elasticity {
            supports: vec![clamp(1)],
            traction: vec![(2, vector([0.0, 0.0, 1e-3]))],
            ..Elasticity::new(Material::new(1e3, 0.0))
        };
        let b = Discretisation::new(&h, &e, &options).unwrap().solve(&options).map(|s| {
            (
                s.report.iterations,
                s.report.ended,
                s.report.relative_residual,
                s.report.backward_error,
                s.report.energy_error,
            )
        });
        println!("TABLE beam {slenderness} levels {levels}: {:?}", b.map_err(|e| e.to_string()));
    }
    for levels in 0..2 {
        let mut h =
            Hierarchy::new(kuhn_box([50, 50, 1], [100.0, 100.0, 1.0]), &FeatureOptions::default());
        (0..levels).for_each(|_| h.subdivide(Scheme::Linear).unwrap());
        let e = Elasticity {
            supports: [1, 2, 3, 4].map(clamp).into(),
            pressure: vec![(6, 1e-6.into())],
            ..Elasticity::new(Material::new(1e3, 0.3))
        };
        let b = Discretisation::new(&h, &e, &options).unwrap().solve(&options).map(|s| {
            (s.report.iterations, s.report.ended, s.report.relative_residual, s.report.energy_error)
        });
        println!("TABLE plate levels {levels}: {:?}", b.map_err(|e| e.to_string()));
    }
}
