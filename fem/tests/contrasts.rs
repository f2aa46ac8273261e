//! Bodies of very different stiffness and slender ones: layers, inclusions, beams, a plate.
//! Closed forms and a direct solution are the judges; of a contrast c rounding leaves 10 ε c.

mod bodies;

use bodies::{scalar_matrix, uneven_box};
use nalgebra::{DMatrix, DVector};
use octruss_fem::*;
use octruss_mesh::shapes::kuhn_box;
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, TetMesh};
use octruss_solver::Ended;
use proptest::prelude::*;

fn allowed(contrast: f64) -> f64 {
    f64::max(1e-6, 10.0 * f64::EPSILON * contrast.max(1.0 / contrast))
}

fn clamp(surface: i32) -> Support {
    Support { surface, held: Held::displacement([0.0; 3]) }
}

/// Region 1 where `inside` holds of a tet's middle, 0 elsewhere.
fn with_regions(mesh: TetMesh, inside: impl Fn([f64; 3]) -> bool) -> TetMesh {
    let mut raw = mesh.into_raw();
    let middle = |tet: &[u32; 4]| {
        std::array::from_fn(|k| tet.iter().map(|v| raw.points[*v as usize][k]).sum::<f64>() / 4.0)
    };
    raw.regions = raw.tets.iter().map(|tet| i32::from(inside(middle(tet)))).collect();
    bodies::checked(raw)
}

fn hierarchy(mesh: TetMesh, levels: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh, &FeatureOptions::default());
    (0..levels).for_each(|_| hierarchy.subdivide(Scheme::Linear).unwrap());
    hierarchy
}

fn solved<P: Problem>(hierarchy: &Hierarchy, problem: &P) -> Solution<P::Entry> {
    let options = Options::default();
    Discretisation::new(hierarchy, problem, &options).unwrap().solve(&options).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// A flux of 1 through a layer of length 1/2 and one c times as conducting:
    /// u = 1/2 + 1/(2 c) at the end.
    #[test]
    fn heat_goes_through_layers_in_series(power in -12.0..12.0, levels in 0usize..3) {
        let contrast = 10f64.powf(power);
        let mesh = with_regions(kuhn_box([8, 4, 4], [1.0, 0.5, 0.5]), |[x, ..]| x > 0.5);
        let body = hierarchy(mesh, levels);
        let problem = Poisson {
            coefficient: ByRegion { default: 1.0.into(), regions: vec![(1, contrast.into())] },
            fixed: vec![(1, 0.0.into())],
            flux: vec![(2, 1.0.into())],
            ..Poisson::default()
        };
        let solution = solved(&body, &problem);
        let expected = 0.5 + 0.5 / contrast;
        let ends = solution.values.iter().zip(body.finest().mesh.points());
        for (u, _) in ends.filter(|(_, p)| p[0] == 1.0) {
            let error = (u / expected - 1.0).abs();
            prop_assert!(error <= allowed(contrast), "{contrast:e}, {levels}: {error:e}");
        }
    }

    /// The same of a pull. (A stiff half that a soft one alone holds is lost to rounding beyond
    /// some 10¹⁰, and the solve is refused.)
    #[test]
    fn a_pull_goes_through_layers_in_series(power in -9.0..9.0, levels in 0usize..2) {
        let contrast = 10f64.powf(power);
        let mesh = with_regions(kuhn_box([8, 4, 4], [1.0, 0.5, 0.5]), |[x, ..]| x > 0.5);
        let body = hierarchy(mesh, levels);
        let regions = vec![(1, Material::new(contrast, 0.0))];
        let problem = Elasticity {
            supports: vec![clamp(1)],
            traction: vec![(2, vector([1.0, 0.0, 0.0]))],
            ..Elasticity::new(ByRegion { default: Material::new(1.0, 0.0), regions })
        };
        let solution = solved(&body, &problem);
        let expected = 0.5 + 0.5 / contrast;
        let ends = solution.values.iter().zip(body.finest().mesh.points());
        for (u, _) in ends.filter(|(_, p)| p[0] == 1.0) {
            let error = (u[0] / expected - 1.0).abs();
            prop_assert!(error <= 1e-6, "{contrast:e}, {levels}: {error:e}");
        }
    }

    #[test]
    fn an_inclusion_of_any_stiffness_is_solved_as_a_direct_solver_does(power in -12.0..12.0) {
        let contrast = 10f64.powf(power);
        let inside = |p: [f64; 3]| p.iter().all(|x| (0.25..0.75).contains(x));
        let body = hierarchy(with_regions(uneven_box([4; 3], [1.0; 3]), inside), 0);
        let regions = vec![(1, Material::new(contrast, 0.3))];
        let problem = pulled(ByRegion { default: Material::new(1.0, 0.3), regions });
        let options = Options::default();
        let discretised = Discretisation::new(&body, &problem, &options).unwrap();
        let found = discretised.solve(&options).unwrap().unknowns;
        let blocks = scalar_matrix(&discretised.matrix);
        let dense = DMatrix::from_fn(blocks.rows(), blocks.rows(), |i, j| {
            blocks.get(i, j).unwrap_or(0.0)
        });
        let factor = dense.cholesky().unwrap();
        let direct = factor.solve(&DVector::from_column_slice(discretised.rhs.as_flattened()));
        let differences = found.as_flattened().iter().zip(&direct).map(|(a, b)| (a - b).abs());
        let error = differences.fold(0.0, f64::max) / direct.amax();
        prop_assert!(error <= allowed(contrast), "{contrast:e}: {error:e}");
    }
}

fn pulled(material: ByRegion<Material>) -> Elasticity {
    Elasticity {
        supports: vec![clamp(1)],
        traction: vec![(2, vector([1.0, 0.5, 0.0]))],
        ..Elasticity::new(material)
    }
}

#[test]
fn iterations_do_not_depend_on_the_stiffness_of_an_inclusion() {
    let inside = |p: [f64; 3]| p.iter().all(|x| (0.25..0.75).contains(x));
    for levels in [0, 1] {
        let body = hierarchy(with_regions(uneven_box([8; 3], [1.0; 3]), inside), levels);
        let [soft, same, hard] = [1e-9, 1.0, 1e9].map(|contrast| {
            let regions = vec![(1, Material::new(contrast, 0.3))];
            let problem = pulled(ByRegion { default: Material::new(1.0, 0.3), regions });
            solved(&body, &problem).report
        });
        assert!(soft.iterations <= same.iterations + 6, "{soft:?} {same:?}");
        // To the end of rounding instead of 1e-8.
        assert!(hard.iterations <= 2 * same.iterations + 10, "{hard:?} {same:?}");
        assert_eq!(hard.ended, Ended::Rounding);
    }
}

#[test]
fn beams_of_any_slenderness_end_well() {
    for (slenderness, levels) in [(30, 0), (30, 2), (100, 0), (100, 2), (200, 0), (200, 1)] {
        let length = f64::from(slenderness);
        let body = hierarchy(kuhn_box([slenderness, 1, 1], [length, 1.0, 1.0]), levels);
        let problem = Elasticity {
            supports: vec![clamp(1)],
            traction: vec![(2, vector([0.0, 0.0, 1e-3]))],
            ..Elasticity::new(Material::new(1e3, 0.0))
        };
        let report = solved(&body, &problem).report;
        assert!(report.iterations <= 80, "{slenderness}, {levels}: {report:?}");
        assert!(report.energy_error.unwrap() < 1e-6, "{slenderness}, {levels}: {report:?}");
    }
}

#[test]
fn a_thin_clamped_plate_ends_well() {
    for levels in [0, 1] {
        let body = hierarchy(kuhn_box([50, 50, 1], [100.0, 100.0, 1.0]), levels);
        let problem = Elasticity {
            supports: [1, 2, 3, 4].map(clamp).into(),
            pressure: vec![(6, 1e-6.into())],
            ..Elasticity::new(Material::new(1e3, 0.3))
        };
        let report = solved(&body, &problem).report;
        assert!(report.iterations <= 100, "{levels}: {report:?}");
        assert!(report.energy_error.unwrap() < 1e-6, "{levels}: {report:?}");
    }
}
