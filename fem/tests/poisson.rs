//! Assembly against slow references, and solutions that are known exactly.

mod bodies;

use bodies::{checked, unit_tet, with_tagged_boundary};
use octruss_fem::Error;
use octruss_fem::*;
use octruss_mesh::shapes::{five_tet_cube, kuhn_cube, regular_tet};
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::*;

fn solve(mesh: &TetMesh, problem: &Poisson) -> Vec<f64> {
    let system = assemble(mesh, &Topology::new(mesh.raw()), problem).unwrap();
    let options = MultigridOptions { precision: Some(Precision::Double), ..Default::default() };
    let mut direct = Multigrid::new(&system.matrix, vec![], &options).unwrap();
    let goal = SolveOptions { tolerance: 1e-13, ..SolveOptions::default() };
    let (x, _) = conjugate_gradients(&system.matrix, &system.rhs, &mut direct, &goal).unwrap();
    system.expand(&x).unwrap()
}

/// Element by element into a dense matrix, gradients by inverting the 3 × 3
/// matrix of edge vectors with Cramer's rule.
fn dense_stiffness(mesh: &TetMesh, k: impl Fn(i32) -> f64) -> Vec<Vec<f64>> {
    let n = mesh.points().len();
    let mut matrix = vec![vec![0.0; n]; n];
    for (t, tet) in mesh.tets().iter().enumerate() {
        let [o, a, b, c] = mesh.corners(t);
        let rows = [a, b, c].map(|p| [p[0] - o[0], p[1] - o[1], p[2] - o[2]]);
        let det3 = |m: [[f64; 3]; 3]| {
            (0..3)
                .map(|i| {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j])
                })
                .sum::<f64>()
        };
        let det = det3(rows);
        let mut gradients = [[0.0; 3]; 4];
        for i in 0..3 {
            for d in 0..3 {
                let mut replaced = rows;
                (0..3).for_each(|r| replaced[r][d] = if r == i { 1.0 } else { 0.0 });
                gradients[i + 1][d] = det3(replaced) / det;
                gradients[0][d] -= gradients[i + 1][d];
            }
        }
        for i in 0..4 {
            for j in 0..4 {
                let product: f64 = (0..3).map(|d| gradients[i][d] * gradients[j][d]).sum();
                matrix[tet[i] as usize][tet[j] as usize] +=
                    k(mesh.regions()[t]) * product * det / 6.0;
            }
        }
    }
    matrix
}

#[test]
fn assembly_agrees_with_the_dense_reference() {
    let mut raw = kuhn_cube(3).into_raw();
    // A mesh without symmetry and with two regions.
    for point in &mut raw.points {
        *point = [point[0] + 0.3 * point[1] * point[2], 1.5 * point[1], point[2] + 0.2 * point[0]];
    }
    for (t, region) in raw.regions.iter_mut().enumerate() {
        *region = (t % 2) as i32;
    }
    let mesh = checked(raw);
    let k = |region: i32| if region == 1 { 7.0 } else { 2.0 };
    let mut coefficient = ByRegion::from(2.0);
    coefficient.regions.push((1, 7.0.into()));
    let fixed = vec![(5, Scalar::function(|[x, y, _]| 1.0 + x - 2.0 * y))];
    let problem = Poisson { coefficient, fixed, ..Poisson::default() };
    let system = assemble(&mesh, &Topology::new(mesh.raw()), &problem).unwrap();
    let reference = dense_stiffness(&mesh, k);
    assert_eq!((system.dofs.vertices(), system.dofs.unknowns(), system.dofs.fixed()), (64, 48, 16));
    let free = system.dofs.free();
    for (row, &v) in free.iter().enumerate() {
        for (column, &w) in free.iter().enumerate() {
            let entry = system.matrix.get(row, column).unwrap_or(0.0);
            assert!((entry - reference[v as usize][w as usize]).abs() < 1e-13);
        }
        let lifted: f64 =
            (0..64).map(|w| -reference[v as usize][w as usize] * system.dofs.value(w as u32)).sum();
        assert!((system.rhs[row] - lifted).abs() < 1e-13);
    }
    assert_eq!(transpose(&system.matrix), system.matrix, "symmetric to the last bit");
}

#[test]
fn one_free_corner_of_the_unit_tet_has_its_textbook_row() {
    // Gradients (−1, −1, −1) and e₁, volume 1/6: diagonal 3/6; a source f gives
    // f V / 4 = f / 24; a flux g on the face x = 0 gives g A / 3 = g / 6.
    let mesh = unit_tet();
    let problem = Poisson {
        source: 48.0.into(),
        fixed: vec![(10, 6.0.into())],
        flux: vec![(11, 12.0.into())],
        ..Poisson::default()
    };
    let system = assemble(&mesh, &Topology::new(mesh.raw()), &problem).unwrap();
    assert_eq!(system.matrix.values(), [0.5]);
    // 48 / 24 + 12 / 6 and, lifted, three couplings of −1/6 with 6.
    assert!((system.rhs[0] - 7.0).abs() < 1e-14);
}

#[test]
fn a_linear_solution_is_exact() {
    for mesh in [with_tagged_boundary(five_tet_cube()), kuhn_cube(4)] {
        let exact = |[x, y, z]: [f64; 3]| 1.0 + 2.0 * x - 3.0 * y + 0.5 * z;
        let fixed =
            mesh.triangles().ids().into_iter().map(|id| (id, Scalar::function(exact))).collect();
        let u = solve(&mesh, &Poisson { fixed, ..Poisson::default() });
        for (u, p) in u.iter().zip(mesh.points()) {
            assert!((u - exact(*p)).abs() < 1e-12);
        }
    }
}

#[test]
fn a_piecewise_linear_solution_across_a_jump_is_exact() {
    // Layers k = 1 below z = 1/2 and k = 10 above; flux 20 enters at the top,
    // so u = 20 z below and 10 + 2 (z − 1/2) above.
    let mut raw = kuhn_cube(4).into_raw();
    for (tet, region) in raw.tets.iter().zip(&mut raw.regions) {
        let height: f64 = tet.iter().map(|&v| raw.points[v as usize][2]).sum::<f64>() / 4.0;
        *region = if height < 0.5 { 1 } else { 2 };
    }
    let mesh = checked(raw);
    let mut coefficient = ByRegion::from(1.0);
    coefficient.regions.push((2, 10.0.into()));
    let flux = vec![(6, Scalar::function(|_| 20.0))];
    let problem = Poisson { coefficient, fixed: vec![(5, 0.0.into())], flux, ..Poisson::default() };
    for (u, [_, _, z]) in solve(&mesh, &problem).iter().zip(mesh.points()) {
        let exact = if *z < 0.5 { 20.0 * z } else { 10.0 + 2.0 * (z - 0.5) };
        assert!((u - exact).abs() < 1e-12, "{u} {exact}");
    }
}

#[test]
fn sources_and_fluxes_balance() {
    // Without lifting, the load adds up to ∫ f + ∫ g; quadratics are integrated
    // exactly: ∫ x² over the cube 1/3, ∫ y² over the side x = 1 1/3.
    let mesh = kuhn_cube(3);
    let problem = Poisson {
        source: ByRegion { default: Scalar::function(|[x, ..]| x * x), regions: vec![] },
        flux: vec![(2, Scalar::function(|[_, y, _]| y * y))],
        fixed: vec![(1, 0.0.into())],
        ..Poisson::default()
    };
    let system = assemble(&mesh, &Topology::new(mesh.raw()), &problem).unwrap();
    let free: f64 = system.rhs.iter().sum();
    // The fixed side x = 0 takes ∫ x² φ over the first layer of cells, where
    // φ = 1 − 3 x: ∫₀^⅓ x² (1 − 3 x) dx = 1/81 − 1/108. The quadrature sees
    // degree 3 there, so only to its own accuracy.
    assert!((free - (2.0 / 3.0 - 1.0 / 324.0)).abs() < 2e-4, "{free}");
}

#[test]
fn errors_shrink_with_the_order_of_the_element() {
    // −Δu = f with u = sin πx sin πy sin πz, which vanishes on all sides.
    use std::f64::consts::PI;
    let u = |[x, y, z]: [f64; 3]| (PI * x).sin() * (PI * y).sin() * (PI * z).sin();
    let slope = |p: [f64; 3]| {
        let (s, c) = (p.map(|t| (PI * t).sin()), p.map(|t| (PI * t).cos()));
        [PI * c[0] * s[1] * s[2], PI * s[0] * c[1] * s[2], PI * s[0] * s[1] * c[2]]
    };
    let errors = [8, 16].map(|n| {
        let mesh = kuhn_cube(n);
        let problem = Poisson {
            source: ByRegion {
                default: Scalar::function(move |p| 3.0 * PI * PI * u(p)),
                regions: vec![],
            },
            fixed: (1..=6).map(|side| (side, 0.0.into())).collect(),
            ..Poisson::default()
        };
        let u_h = solve(&mesh, &problem);
        [l2_error(&mesh, &u_h, u), h1_seminorm_error(&mesh, &u_h, slope)]
    });
    let rates = [0, 1].map(|norm| (errors[0][norm] / errors[1][norm]).log2());
    assert!(rates[0] > 1.85 && rates[1] > 0.95, "{rates:?}");
}

#[test]
fn exchange_with_a_surrounding_across_a_layer_is_exact() {
    // k = 3 and flux 6 entering at z = 0: u falls by 2 a unit of height, and
    // leaves at z = 1 with 6 = 4 (u(1) − 5), so u = 6.5 + 2 (1 − z). Nothing is
    // fixed.
    let problem = Poisson {
        coefficient: 3.0.into(),
        flux: vec![(5, 6.0.into())],
        robin: vec![(6, Robin { coefficient: 4.0.into(), value: 5.0.into() })],
        ..Poisson::default()
    };
    let mesh = kuhn_cube(4);
    for (u, [_, _, z]) in solve(&mesh, &problem).iter().zip(mesh.points()) {
        assert!((u - (6.5 + 2.0 * (1.0 - z))).abs() < 1e-12, "{u} at {z}");
    }
}

#[test]
fn errors_with_robin_conditions_shrink_at_the_rate_of_the_element() {
    // u = eˣ cos y + z² with k = 1, −Δu = −2; on x = 1, where ∂u/∂n = ∂u/∂x,
    // c = 1 + y + z² and u₀ = u + (∂u/∂x) / c. The other sides are prescribed.
    let u = |[x, y, z]: [f64; 3]| x.exp() * y.cos() + z * z;
    let c = |[_, y, z]: [f64; 3]| 1.0 + y + z * z;
    let surrounding = move |p: [f64; 3]| u(p) + p[0].exp() * p[1].cos() / c(p);
    let errors = [4, 8, 16].map(|n| {
        let mesh = kuhn_cube(n);
        let robin =
            Robin { coefficient: Scalar::function(c), value: Scalar::function(surrounding) };
        let problem = Poisson {
            source: (-2.0).into(),
            fixed: [1, 3, 4, 5, 6].map(|side| (side, Scalar::function(u))).into(),
            robin: vec![(2, robin)],
            ..Poisson::default()
        };
        l2_error(&mesh, &solve(&mesh, &problem), u)
    });
    let rates = [0, 1].map(|k| (errors[k] / errors[k + 1]).log2());
    assert!(rates[1] > 1.9 && rates[1] < 2.1, "{rates:?}");
}

#[test]
fn a_huge_exchange_coefficient_prescribes_and_a_tiny_one_insulates() {
    // k = 1, u = 0 at z = 0: with exchange c to u₀ = 1 at z = 1, u = z c / (1 + c).
    let mesh = kuhn_cube(2);
    for c in [1e-12, 1.0, 1e12] {
        let problem = Poisson {
            fixed: vec![(5, 0.0.into())],
            robin: vec![(6, Robin { coefficient: c.into(), value: 1.0.into() })],
            ..Poisson::default()
        };
        for (u, [_, _, z]) in solve(&mesh, &problem).iter().zip(mesh.points()) {
            let exact = z * c / (1.0 + c);
            assert!((u - exact).abs() <= 1e-10 * c / (1.0 + c), "{c}: {u} for {exact}");
        }
    }
}

#[test]
fn the_last_listed_surface_wins_at_a_common_vertex() {
    let mesh = kuhn_cube(1);
    let fixed = vec![(1, 5.0.into()), (3, 7.0.into())];
    let dofs = Dofs::new(&mesh, &fixed).unwrap();
    // Vertex 0 lies on x0 and y0, vertex 2 = (0, 1, 0) on x0 alone.
    assert_eq!((dofs.value(0), dofs.value(2)), (7.0, 5.0));
    assert_eq!(dofs.unknown(0), None);
    assert_eq!(dofs.expand(&[1.0, 2.0]).unwrap(), [7.0, 7.0, 5.0, 1.0, 7.0, 7.0, 5.0, 2.0]);
    assert!(matches!(
        dofs.expand(&[1.0]),
        Err(Error::Solver(octruss_solver::Error::Size { found: 1, expected: 2, .. }))
    ));
}

#[test]
fn senseless_problems_are_refused() {
    let mesh = kuhn_cube(2);
    let topology = Topology::new(mesh.raw());
    let refused = |problem: Poisson| assemble(&mesh, &topology, &problem).unwrap_err();
    let zero = || vec![(1, Scalar::Constant(0.0))];
    let nothing = refused(Poisson::default());
    assert!(matches!(nothing, Error::NothingFixed { vertices: 27, example: 0 }));
    let unknown = refused(Poisson { fixed: vec![(9, 0.0.into())], ..Poisson::default() });
    assert_eq!(
        unknown.to_string(),
        "no triangle belongs to surface 9; surfaces of this mesh: [1, 2, 3, 4, 5, 6]"
    );
    let unknown = Poisson { fixed: zero(), flux: vec![(7, 0.0.into())], ..Poisson::default() };
    assert!(matches!(refused(unknown), Error::UnknownSurface { id: 7, .. }));
    let region = ByRegion { default: 1.0.into(), regions: vec![(3, 1.0.into())] };
    let unknown = Poisson { coefficient: region.clone(), fixed: zero(), ..Poisson::default() };
    assert!(matches!(refused(unknown), Error::UnknownRegion { id: 3, .. }));
    let unknown = Poisson { source: region, fixed: zero(), ..Poisson::default() };
    assert!(matches!(refused(unknown), Error::UnknownRegion { id: 3, .. }));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let problem = Poisson { coefficient: bad.into(), fixed: zero(), ..Poisson::default() };
        assert!(matches!(refused(problem), Error::Coefficient { tet: 0, region: 0, .. }));
    }
    let fixed = vec![(2, Scalar::function(|[_, y, _]| 1.0 / y))];
    let infinite = refused(Poisson { fixed, ..Poisson::default() });
    assert!(matches!(infinite, Error::BoundaryValue { surface: 2, .. }));
    let infinite = Poisson { source: f64::NAN.into(), fixed: zero(), ..Poisson::default() };
    assert!(matches!(refused(infinite), Error::Load { what: "source", .. }));
    let log = Scalar::expression("ln(x - 0.5)", |[x, ..]| (x - 0.5).ln());
    let infinite = Poisson { flux: vec![(3, log)], fixed: zero(), ..Poisson::default() };
    let told = refused(infinite).to_string();
    assert!(
        told.starts_with("the flux of surface 3 is `ln(x - 0.5)` = NaN at (0.25, 0, "),
        "{told}"
    );
    for bad in [-1.0, f64::NAN] {
        let robin = vec![(4, Robin { coefficient: bad.into(), value: 0.0.into() })];
        let problem = Poisson { robin, fixed: zero(), ..Poisson::default() };
        assert!(matches!(refused(problem), Error::SurfaceCoefficient { surface: 4, .. }));
    }
    // Exchange with coefficient 0 ties nothing.
    let robin = vec![(4, Robin { coefficient: 0.0.into(), value: 0.0.into() })];
    let loose = refused(Poisson { robin, ..Poisson::default() });
    assert!(matches!(loose, Error::NothingFixed { vertices: 27, example: 0 }));
    let other = Topology::new(kuhn_cube(1).raw());
    let problem = Poisson { fixed: zero(), ..Poisson::default() };
    assert!(matches!(
        assemble(&mesh, &other, &problem),
        Err(Error::Solver(octruss_solver::Error::Size { .. }))
    ));
}

#[test]
fn a_flux_beside_the_body_is_refused() {
    let mut raw = kuhn_cube(1).into_raw();
    raw.points.extend([[2.0, 0.0, 0.0], [3.0, 0.0, 0.0], [2.0, 1.0, 0.0]]);
    raw.triangles.push([8, 9, 10], 70);
    let mesh = checked(raw);
    let flux = vec![(70, 1.0.into())];
    let problem = Poisson { fixed: vec![(1, 0.0.into())], flux, ..Poisson::default() };
    let refused = assemble(&mesh, &Topology::new(mesh.raw()), &problem);
    assert!(matches!(refused, Err(Error::DetachedSurface { id: 70, detached: 1 })));
    // Nor may a triangle only hang on the body by its corners.
    let mut raw = mesh.into_raw();
    raw.triangles.push([1, 2, 4], 71);
    let mesh = checked(raw);
    let flux = vec![(71, 1.0.into())];
    let problem = Poisson { fixed: vec![(1, 0.0.into())], flux, ..Poisson::default() };
    let refused = assemble(&mesh, &Topology::new(mesh.raw()), &problem);
    assert!(matches!(refused, Err(Error::DetachedSurface { id: 71, detached: 1 })));
}

#[test]
fn every_part_of_the_mesh_must_be_fixed() {
    // Two tets apart; only the first has a tagged face. A free-standing edge
    // between them couples nothing.
    let mut raw = regular_tet().into_raw();
    let far: Vec<[f64; 3]> = raw.points.iter().map(|p| [p[0] + 9.0, p[1], p[2]]).collect();
    raw.points.extend(far);
    raw.tets.push(raw.tets[0].map(|v| v + 4));
    raw.regions.push(0);
    raw.triangles.push([raw.tets[0][0], raw.tets[0][1], raw.tets[0][2]], 1);
    raw.edges.push([3, 4], 2);
    let mesh = checked(raw);
    let problem = Poisson { fixed: vec![(1, 0.0.into())], ..Poisson::default() };
    let refused = assemble(&mesh, &Topology::new(mesh.raw()), &problem);
    assert!(matches!(refused, Err(Error::NothingFixed { vertices: 4, example: 4 })));
}

#[test]
fn assembly_gives_the_same_bits_for_any_number_of_threads() {
    let mesh = kuhn_cube(16);
    let topology = Topology::new(mesh.raw());
    let problem = Poisson {
        coefficient: ByRegion {
            default: Scalar::function(|[x, y, z]| 1.0 + x * y + z),
            regions: vec![],
        },
        source: ByRegion { default: Scalar::function(|[x, ..]| x.sin()), regions: vec![] },
        fixed: vec![(1, 1.0.into())],
        ..Poisson::default()
    };
    let results = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let system = pool.install(|| assemble(&mesh, &topology, &problem).unwrap());
        (system.matrix, system.rhs)
    });
    assert_eq!(results[0], results[1]);
    assert_eq!(results[0], results[2]);
}
