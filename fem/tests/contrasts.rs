//! Bodies of very different stiffness: stiff and soft inclusions, layers, slender beams. A
//! direct solution or a closed form is the judge; of a contrast c rounding leaves 10 ε c.

mod bodies;

use bodies::uneven_box;
use octruss_fem::*;
use octruss_mesh::shapes::kuhn_box;
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, TetMesh};

const CONTRASTS: [f64; 8] = [1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e12];

fn allowed(contrast: f64) -> f64 {
    f64::max(1e-6, 10.0 * f64::EPSILON * contrast.max(1.0 / contrast))
}

fn clamp(surface: i32) -> Support {
    Support { surface, held: Held::Components([0, 1, 2].map(|_| Some(0.0.into()))) }
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
    let options = Options { prolongation: Some(Scheme::Linear.into()), ..Options::default() };
    Discretisation::new(hierarchy, problem, &options).unwrap().solve(&options).unwrap()
}

#[test]
fn heat_goes_through_layers_in_series() {
    // Flux 1 through a soft and a hard layer of length 1/2: u = 1/2 + 1/(2 c) at the end.
    for levels in [0, 1, 2] {
        for contrast in CONTRASTS {
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
            for (u, p) in solution.values.iter().zip(body.finest().mesh.points()) {
                if p[0] == 1.0 {
                    let error = (u / expected - 1.0).abs();
                    println!(
                        "heat {levels} {contrast:e}: {error:e} {:e}",
                        error / allowed(contrast)
                    );
                }
            }
        }
    }
}

#[test]
fn inclusions_of_any_stiffness_are_solved_for() {
    for levels in [0, 1] {
        let inside = |p: [f64; 3]| p.iter().all(|x| (0.25..0.75).contains(x));
        let body = hierarchy(with_regions(uneven_box([8; 3], [1.0; 3]), inside), levels);
        for contrast in CONTRASTS {
            let regions = vec![(1, Material::new(contrast, 0.3))];
            let problem = Elasticity {
                supports: vec![clamp(1)],
                traction: vec![(2, vector([1.0, 0.5, 0.0]))],
                ..Elasticity::new(ByRegion { default: Material::new(1.0, 0.3), regions })
            };
            let solution = solved(&body, &problem);
            assert!(solution.report.iterations <= 60, "{:?}", solution.report);
            // Between what all soft and all hard gives.
            println!(
                "{contrast:e} {levels}: {} {:?} {:e}",
                solution.report.iterations,
                solution.report.ended,
                solution.report.relative_residual
            );
        }
    }
}

#[test]
fn slender_beams_end_well() {
    for (slenderness, levels) in [(30, 0), (30, 2), (100, 0), (100, 2), (200, 1)] {
        let length = f64::from(slenderness);
        let body = hierarchy(kuhn_box([slenderness, 1, 1], [length, 1.0, 1.0]), levels);
        let problem = Elasticity {
            supports: vec![clamp(1)],
            traction: vec![(2, vector([0.0, 0.0, 1e-3]))],
            ..Elasticity::new(Material::new(1e3, 0.0))
        };
        let solution = solved(&body, &problem);
        println!(
            "beam {slenderness} {levels}: {} {:?} {:e} {:?} {:?}",
            solution.report.iterations,
            solution.report.ended,
            solution.report.relative_residual,
            solution.report.backward_error,
            solution.report.energy_error
        );
    }
    let body = hierarchy(kuhn_box([50, 50, 1], [100.0, 100.0, 1.0]), 1);
    let problem = Elasticity {
        supports: [1, 2, 3, 4].map(clamp).into(),
        pressure: vec![(6, 1e-6.into())],
        ..Elasticity::new(Material::new(1e3, 0.3))
    };
    let solution = solved(&body, &problem);
    println!(
        "plate: {} {:?} {:e} {:?} {:?}",
        solution.report.iterations,
        solution.report.ended,
        solution.report.relative_residual,
        solution.report.backward_error,
        solution.report.energy_error
    );
}
