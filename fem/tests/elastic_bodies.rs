//! Bodies with closed solutions: Lamé's thick sphere and Timoshenko's cantilever,
//! with the rates at which errors shrink.

mod bodies;

use bodies::{INNER, SYMMETRY, errors, sliding, solve, thick_sphere};
use octruss_fem::*;
use octruss_mesh::TetMesh;
use octruss_mesh::shapes::kuhn_box;

/// Lamé's sphere of radii a = 1 and b = 2 under a pressure of 1 from inside, with
/// C = a³ / (b³ − a³): E u_r = C ((1 − 2ν) r + (1 + ν) b³ / (2 r²)). The factors
/// of r and 1 / r², with E = 1.
fn lame(nu: f64) -> (f64, f64) {
    let c = 1.0 / 7.0;
    (c * (1.0 - 2.0 * nu), c * (1.0 + nu) * 4.0)
}

fn radius(p: [f64; 3]) -> f64 {
    p.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// u and ∇u of the sphere, ∇u from u = (α + β / r³) x.
fn sphere_errors(mesh: &TetMesh, nu: f64) -> [f64; 2] {
    let problem = Elasticity {
        pressure: vec![(INNER, 1.0.into())],
        supports: sliding(&SYMMETRY),
        ..Elasticity::new(Material::new(1.0, nu))
    };
    let u_h = solve(mesh, &problem);
    let (alpha, beta) = lame(nu);
    let u = |p: [f64; 3]| p.map(|x| (alpha + beta / radius(p).powi(3)) * x);
    let gradient = |p: [f64; 3]| {
        let r = radius(p);
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let unit = if i == j { alpha + beta / r.powi(3) } else { 0.0 };
                unit - 3.0 * beta * p[i] * p[j] / r.powi(5)
            })
        })
    };
    errors(mesh, &u_h, u, gradient)
}

fn rates(errors: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let rate = |pair: &[[f64; 2]]| std::array::from_fn(|k| (pair[0][k] / pair[1][k]).log2());
    errors.windows(2).map(rate).collect()
}

#[test]
fn a_thick_sphere_under_pressure_converges_to_lames_solution() {
    let errors = [2, 4, 8].map(|layers| sphere_errors(&thick_sphere(layers), 0.3));
    let rates = rates(&errors);
    assert!(rates[1][0] > 1.85 && rates[1][1] > 0.95, "{errors:?} {rates:?}");
    // ‖u‖² = π/2 ∫ u_r² r² dr = π/2 (31/5 α² + 3 α β + β²/2) with α = 0.4/7 and
    // β = 5.2/7, so ‖u‖ = 0.8156: within 2 %.
    assert!(errors[2][0] < 0.02 * 0.8156, "{errors:?}");
}

#[test]
fn a_nearly_incompressible_sphere_locks_but_converges() {
    let coarse_errors = [0.3, 0.49].map(|nu| sphere_errors(&thick_sphere(4), nu)[0]);
    assert!(coarse_errors[1] > 4.0 * coarse_errors[0], "{coarse_errors:?}");
    let fine_error = sphere_errors(&thick_sphere(8), 0.49)[0];
    assert!(fine_error < 0.5 * coarse_errors[1], "{fine_error} after {coarse_errors:?}");
}

/// Timoshenko and Goodier's cantilever of length L = 4 and depth D = 1 with the
/// end load P = 1 a unit of width, E = 1000, and ν = 0, for which the plane
/// solution is one in space: held at x = 0 as the solution asks, sheared by the
/// parabola at x = L. y is from −1/2 to 1/2, here moved up by 1/2.
const LENGTH: f64 = 4.0;
const YOUNG: f64 = 1000.0;

fn cantilever([x, y, _]: [f64; 3]) -> [f64; 3] {
    let (y, factor) = (y - 0.5, 2.0 / YOUNG); // P / (6 E I), I = 1/12
    [
        factor * y * ((6.0 * LENGTH - 3.0 * x) * x + 2.0 * (y * y - 0.25)),
        -factor * (x + (3.0 * LENGTH - x) * x * x),
        0.0,
    ]
}

fn cantilever_gradient([x, y, _]: [f64; 3]) -> [[f64; 3]; 3] {
    let (y, factor) = (y - 0.5, 2.0 / YOUNG);
    let bend = factor * (6.0 * LENGTH * x - 3.0 * x * x);
    [
        [factor * y * (6.0 * LENGTH - 6.0 * x), bend + factor * (6.0 * y * y - 0.5), 0.0],
        [-factor - bend, 0.0, 0.0],
        [0.0; 3],
    ]
}

#[test]
fn a_cantilever_bends_as_timoshenko_says() {
    let solved = [2, 4, 8].map(|n| {
        let mesh = kuhn_box([8 * n, 2 * n, n], [LENGTH, 1.0, 0.5]);
        let component = |k: usize| Some(Scalar::function(move |p| cantilever(p)[k]));
        let shear = Scalar::function(|[_, y, _]| -6.0 * (0.25 - (y - 0.5).powi(2)));
        let problem = Elasticity {
            traction: vec![(2, [0.0.into(), shear, 0.0.into()])],
            supports: vec![Support {
                surface: 1,
                held: Held::Components([0, 1, 2].map(component)),
            }],
            ..Elasticity::new(Material::new(YOUNG, 0.0))
        };
        let u = solve(&mesh, &problem);
        let tip = u.iter().zip(mesh.points()).filter(|(_, p)| p[0] == LENGTH && p[1] == 0.5);
        let tip = tip.map(|(u, _)| u[1]).fold(0.0, f64::min);
        (errors(&mesh, &u, cantilever, cantilever_gradient), tip)
    });
    let rates = rates(&solved.map(|(errors, _)| errors));
    assert!(rates[1][0] > 1.7 && rates[1][1] > 0.9, "{rates:?} {solved:?}");
    // (P / 6 E I) (L + 2 L³) = 0.264 down.
    let errors = solved.map(|(_, tip)| tip + 0.264);
    assert!(errors[2] > 0.0 && errors[2] < 0.02 * 0.264, "too stiff, and by less: {errors:?}");
    let extrapolated = (4.0 * errors[2] - errors[1]) / 3.0;
    assert!(extrapolated.abs() < 0.003 * 0.264, "{errors:?}");
}
