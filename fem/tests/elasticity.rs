//! Assembly of elasticity against slow references, and patches that linear elements
//! solve exactly.

mod bodies;

use bodies::{
    affine, affine_support, assert_near, checked, scalar_matrix, solve, uneven_box, unit_tet,
    with_tagged_boundary,
};
use octruss_fem::*;
use octruss_mesh::shapes::five_tet_cube;
use octruss_mesh::{TetMesh, Topology};
use octruss_solver::*;

/// σ of the affine displacement with E = 10 and ν = 1/4: λ = μ = 4.
fn affine_stress() -> [f64; 6] {
    // ε: xx 0.3, yy 0.4, zz 0.1, xy −0.05, yz −0.2, xz −0.1; trace 0.8.
    [5.6, 6.4, 4.0, -0.4, -1.6, -0.8]
}

#[test]
fn the_patch_test_is_exact_with_displacements_all_round() {
    // A tet in a corner of the five-tet cube has its stress from the boundary
    // alone; the uneven box has inner vertices to solve for.
    for mesh in [
        with_tagged_boundary(five_tet_cube()),
        uneven_box([4, 3, 5], [1.0, 1.5, 2.0]),
        uneven_box([6, 6, 6], [1.0, 1.0, 1.0]),
    ] {
        let supports = mesh.triangles().ids().into_iter().map(affine_support).collect();
        let problem = Elasticity { supports, ..Elasticity::new(Material::new(10.0, 0.25)) };
        let u = solve(&mesh, &problem);
        assert_near(&u, |v| affine(mesh.points()[v]), 1e-12);
        let strain = strains(&mesh, &u).unwrap();
        assert_near(&strain, |_| [0.3, 0.4, 0.1, -0.05, -0.2, -0.1], 1e-12);
        let stress = stresses(&mesh, &problem, &strain).unwrap();
        assert_near(&stress, |_| affine_stress(), 1e-12 * 10.0);
        let recovered = Recovery::new(&mesh, |_| true).at_vertices(&stress).unwrap();
        assert_near(&recovered, |_| affine_stress(), 1e-12 * 10.0);
    }
}

#[test]
fn the_patch_test_is_exact_with_tractions() {
    // One side is prescribed, the tractions σ n of the others are given.
    let mesh = uneven_box([3, 4, 3], [1.0, 1.0, 2.0]);
    let [xx, yy, zz, xy, yz, xz] = affine_stress();
    let columns = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let traction = |surface: i32| {
        let axis = (surface as usize - 1) / 2;
        let sign = if surface % 2 == 0 { 1.0 } else { -1.0 };
        (surface, vector(columns[axis].map(|s| sign * s)))
    };
    let problem = Elasticity {
        supports: vec![affine_support(1)],
        traction: (2..=6).map(traction).collect(),
        ..Elasticity::new(Material::new(10.0, 0.25))
    };
    let u = solve(&mesh, &problem);
    assert_near(&u, |v| affine(mesh.points()[v]), 1e-11);
}

#[test]
fn the_patch_test_is_exact_between_sliding_planes_that_move() {
    // u = (0.1 x, −0.2 y, 0.3 z): nothing drags along any side. Outward normals
    // point down on the sides at 0.
    let size = [1.0, 2.0, 1.5];
    let stretch = [0.1, -0.2, 0.3];
    let mesh = uneven_box([3, 4, 3], size);
    let moved = |side: usize| stretch[side / 2] * size[side / 2] * (side % 2) as f64;
    let support =
        |side: usize| Support { surface: side as i32 + 1, held: Held::Normal(moved(side).into()) };
    let problem = Elasticity {
        supports: (0..6).map(support).collect(),
        ..Elasticity::new(Material::new(7.0, 0.3))
    };
    let u = solve(&mesh, &problem);
    let exact = |v: usize| std::array::from_fn(|k| stretch[k] * mesh.points()[v][k]);
    assert_near(&u, exact, 1e-12);
}

/// ∫ Bᵀ D B in engineers' notation, dense: gradients by Cramer's rule.
fn dense_stiffness(mesh: &TetMesh, young: impl Fn(i32) -> f64, nu: f64) -> Vec<Vec<f64>> {
    let n = 3 * mesh.points().len();
    let mut matrix = vec![vec![0.0; n]; n];
    for (t, tet) in mesh.tets().iter().enumerate() {
        let corners = mesh.corners(t);
        let det3 = |m: [[f64; 3]; 3]| {
            m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
                - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
        };
        let rows: [[f64; 3]; 3] =
            std::array::from_fn(|r| std::array::from_fn(|d| corners[r + 1][d] - corners[0][d]));
        let det = det3(rows);
        let mut b = [[0.0; 12]; 6];
        for i in 0..3 {
            let gradient: [f64; 3] = std::array::from_fn(|d| {
                let mut replaced = rows;
                (0..3).for_each(|r| replaced[r][d] = if r == i { 1.0 } else { 0.0 });
                det3(replaced) / det
            });
            for (vertex, sign) in [(i + 1, 1.0), (0, -1.0)] {
                let [x, y, z] = gradient.map(|g| sign * g);
                let at = 3 * vertex;
                for (row, entries) in [
                    [x, 0.0, 0.0],
                    [0.0, y, 0.0],
                    [0.0, 0.0, z],
                    [y, x, 0.0],
                    [0.0, z, y],
                    [z, 0.0, x],
                ]
                .into_iter()
                .enumerate()
                {
                    (0..3).for_each(|k| b[row][at + k] += entries[k]);
                }
            }
        }
        let e = young(mesh.regions()[t]);
        let factor = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
        let d = |i: usize, j: usize| match (i < 3, j < 3) {
            (true, true) => factor * if i == j { 1.0 - nu } else { nu },
            (false, false) if i == j => factor * (1.0 - 2.0 * nu) / 2.0,
            _ => 0.0,
        };
        for p in 0..12 {
            for q in 0..12 {
                let (row, column) =
                    (3 * tet[p / 3] as usize + p % 3, 3 * tet[q / 3] as usize + q % 3);
                for i in 0..6 {
                    for j in 0..6 {
                        matrix[row][column] += det / 6.0 * b[i][p] * d(i, j) * b[j][q];
                    }
                }
            }
        }
    }
    matrix
}

#[test]
fn assembly_agrees_with_the_dense_reference() {
    let mut raw = uneven_box([2, 3, 2], [1.0, 1.0, 1.0]).into_raw();
    for (t, region) in raw.regions.iter_mut().enumerate() {
        *region = (t % 2) as i32;
    }
    // A skew body, so that the sliding plane has a skew normal.
    for point in &mut raw.points {
        *point = [point[0] + 0.4 * point[1], point[1], point[2] + 0.2 * point[0]];
    }
    let mesh = checked(raw);
    let mut material = ByRegion::from(Material::new(2.0, 0.3));
    material.regions.push((1, Material::new(7.0, 0.3)));
    let lean = Held::Components([None, Some(0.5.into()), None]);
    let problem = Elasticity {
        supports: vec![
            affine_support(5),
            Support { surface: 1, held: Held::Normal(0.25.into()) },
            Support { surface: 4, held: lean },
        ],
        ..Elasticity::new(material)
    };
    let system = assemble_elasticity(&mesh, &Topology::new(mesh.raw()), &problem).unwrap();
    let n = 3 * mesh.points().len();
    let reference = dense_stiffness(&mesh, |region| if region == 1 { 7.0 } else { 2.0 }, 0.3);
    // Q and g, dense; the scale s is read off the held diagonal.
    let mut q = vec![vec![0.0; n]; n];
    let mut g = vec![0.0; n];
    (0..n).for_each(|i| q[i][i] = 1.0);
    for held in system.constraints.held() {
        let at = 3 * held.vertex as usize;
        for i in 0..3 {
            g[at + i] = held.value[i];
            (0..3).for_each(|j| q[at + i][at + j] = held.projector[i][j]);
        }
    }
    let times = |a: &[Vec<f64>], b: &[Vec<f64>]| -> Vec<Vec<f64>> {
        let entry = |i: usize, j: usize| (0..n).map(|k| a[i][k] * b[k][j]).sum();
        (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
    };
    let projected = times(&times(&q, &reference), &q);
    let matrix = scalar_matrix(&system.matrix);
    let free = system.constraints.dofs().free();
    let full = |i: usize| 3 * free[i / 3] as usize + i % 3;
    for i in 0..matrix.rows() {
        for j in 0..matrix.rows() {
            let mut exact = projected[full(i)][full(j)];
            if i / 3 == j / 3 {
                let first = full(i) - i % 3;
                let mean = (0..3).map(|k| reference[first + k][first + k]).sum::<f64>() / 3.0;
                let unit = if i == j { 1.0 } else { 0.0 };
                exact += mean * (unit - q[full(i)][full(j)]);
            }
            let found = matrix.get(i, j).unwrap_or(0.0);
            assert!((found - exact).abs() < 1e-12, "{i} {j}: {found} for {exact}");
        }
        let lifted = |row: usize| -> f64 { -(0..n).map(|k| reference[row][k] * g[k]).sum::<f64>() };
        let exact: f64 = (0..n).map(|k| q[full(i)][k] * lifted(k)).sum();
        assert!((system.rhs[i / 3][i % 3] - exact).abs() < 1e-12);
    }
    assert_eq!(transpose(&matrix), matrix, "symmetric to the last bit");
}

#[test]
fn one_free_corner_of_the_unit_tet_has_its_textbook_block_and_load() {
    // At the corner 0 with the gradient −(1, 1, 1): V (λ + μ) everywhere and 3 V μ
    // more on the diagonal; E = 10, ν = 1/4: λ = μ = 4, V = 1/6.
    let mesh = unit_tet();
    let material = Material { density: 6.0.into(), ..Material::new(10.0, 0.25) };
    let problem = Elasticity {
        body_force: vector([24.0, 0.0, 0.0]).into(),
        gravity: vector([0.0, 0.0, -8.0]),
        traction: vec![(11, vector([0.0, 12.0, 0.0]))],
        pressure: vec![(11, 30.0.into())],
        springs: vec![(11, Stiffness::Normal(36.0.into()))],
        supports: vec![Support { surface: 10, held: Held::displacement([0.0; 3]) }],
        ..Elasticity::new(material)
    };
    let system = assemble_elasticity(&mesh, &Topology::new(mesh.raw()), &problem).unwrap();
    // The springs hold x alone: k A / 6 = 36 · (1/2) / 6 = 3.
    let exact = [
        [10.0 / 3.0 + 3.0, 4.0 / 3.0, 4.0 / 3.0],
        [4.0 / 3.0, 10.0 / 3.0, 4.0 / 3.0],
        [4.0 / 3.0, 4.0 / 3.0, 10.0 / 3.0],
    ];
    assert_near(&system.matrix.values()[0], |i| exact[i], 1e-14);
    // A quarter of volume forces, a third of surface forces; pressure pushes in,
    // towards +x: 24/24 + 30/6; 12/6; −48/24.
    assert_near(&system.rhs, |_| [6.0, 2.0, -2.0], 1e-14);
}
