//! Recovery of stresses and forces against slow references, one tet after another.

mod bodies;

use bodies::{affine, affine_support, assert_near, checked, uneven_box};
use octruss_fem::*;
use octruss_mesh::{TetMesh, Topology};

/// Several chunks of tets in two regions, the left and the right.
fn two_regions() -> TetMesh {
    let mut raw = uneven_box([12, 9, 11], [2.0, 1.5, 1.0]).into_raw();
    for (tet, region) in raw.tets.iter().zip(&mut raw.regions) {
        let is_left = tet.iter().map(|&v| raw.points[v as usize][0]).sum::<f64>() < 3.5;
        *region = if is_left { 1 } else { 2 };
    }
    checked(raw)
}

/// Neither affine nor symmetric.
fn displacement(mesh: &TetMesh) -> Vec<[f64; 3]> {
    let bent = |p: &[f64; 3]| {
        let [x, y, z] = affine(*p);
        [x + 0.1 * (3.0 * p[1]).sin(), y + 0.1 * p[0] * p[2], z - 0.2 * p[0] * p[0]]
    };
    mesh.points().iter().map(bent).collect()
}

fn two_materials() -> ByRegion<Material> {
    let mut material = ByRegion::from(Material::new(3.0, 0.2));
    let young = Scalar::function(|[x, y, _]| 10.0 + x * y);
    material.regions.push((2, Material { young, ..Material::new(1.0, 0.3) }));
    material
}

#[test]
fn the_mean_at_a_vertex_is_that_of_a_loop_over_the_tets_to_the_last_bit() {
    let mesh = two_regions();
    let values = strains(&mesh, &displacement(&mesh)).unwrap();
    let sides: [fn(i32) -> bool; 3] = [|id| id == 1, |id| id == 2, |_| true];
    let mut missing = [0; 3];
    for (side, missing) in sides.into_iter().zip(&mut missing) {
        let recovered = Recovery::new(&mesh, side).at_vertices(&values).unwrap();
        let mut sums = vec![([0.0; 6], 0.0); mesh.points().len()];
        for (tet, vertices) in mesh.tets().iter().enumerate() {
            if side(mesh.regions()[tet]) {
                for &vertex in vertices {
                    let (sum, total) = &mut sums[vertex as usize];
                    (0..6).for_each(|k| sum[k] += mesh.volume(tet) * values[tet][k]);
                    *total += mesh.volume(tet);
                }
            }
        }
        for (found, (sum, total)) in recovered.iter().zip(sums) {
            if total > 0.0 {
                assert_eq!(*found, sum.map(|sum| sum / total));
            } else {
                assert!(found.iter().all(|value| value.is_nan()));
                *missing += 1;
            }
        }
    }
    assert!(missing[0] > 100 && missing[1] > 100 && missing[2] == 0);
}

#[test]
fn a_value_that_is_no_number_stays_on_its_side() {
    let mesh = two_regions();
    let values: Vec<[f64; 1]> =
        mesh.regions().iter().map(|&id| [if id == 1 { 5.0 } else { f64::NAN }]).collect();
    let recovered = Recovery::new(&mesh, |id| id == 1).at_vertices(&values).unwrap();
    for (tet, vertices) in mesh.tets().iter().enumerate().filter(|(t, _)| mesh.regions()[*t] == 1) {
        for &vertex in vertices {
            assert!((recovered[vertex as usize][0] - 5.0).abs() < 1e-14, "at tet {tet}");
        }
    }
}

#[test]
fn equivalent_stresses_are_those_of_one_tet_after_another() {
    let mesh = two_regions();
    let problem = Elasticity::new(two_materials());
    let stress = stresses(&mesh, &problem, &strains(&mesh, &displacement(&mesh)).unwrap()).unwrap();
    let slow: Vec<f64> = stress.iter().map(von_mises).collect();
    assert_eq!(equivalent_stresses(&stress), slow);
}

/// Support and springs share the vertices of an edge; what holds the body there is
/// the resistance of all tets, less the forces of the springs and the loads.
#[test]
fn supports_carry_the_resistance_of_all_tets_less_springs_and_loads() {
    let mesh = two_regions();
    let topology = Topology::new(mesh.raw());
    let problem = Elasticity {
        traction: vec![(1, vector([1.0, 2.0, 0.5]))],
        springs: vec![(3, Stiffness::Axes([2.0, 3.0, 4.0].map(Scalar::from)))],
        supports: vec![affine_support(1), affine_support(2)],
        ..Elasticity::new(two_materials())
    };
    let u = displacement(&mesh);
    let stress = stresses(&mesh, &problem, &strains(&mesh, &u).unwrap()).unwrap();
    let constraints = Constraints::new(&mesh, &topology, &problem.supports).unwrap();
    let forces = Forces::new((&mesh, &topology), &problem, &constraints, &u, &stress).unwrap();

    let mut rest = vec![[0.0; 3]; mesh.points().len()];
    for (tet, vertices) in mesh.tets().iter().enumerate() {
        let [xx, yy, zz, xy, yz, xz] = stress[tet];
        let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        for (corner, &vertex) in vertices.iter().enumerate() {
            let slope = shape_gradient(mesh.corners(tet), corner);
            for (rest, row) in rest[vertex as usize].iter_mut().zip(rows) {
                *rest += mesh.volume(tet) * (0..3).map(|k| row[k] * slope[k]).sum::<f64>();
            }
        }
    }
    let mut springs = [0.0; 3];
    for (triangle, tag) in mesh.triangles().iter() {
        let area = area(triangle.map(|v| mesh.points()[v as usize]));
        for [a, b] in [[0, 1], [0, 2], [1, 2]].map(|ends| ends.map(|v| triangle[v] as usize)) {
            for k in 0..3 {
                let pull = [2.0, 3.0, 4.0][k] * area / 3.0 * 0.5 * (u[a][k] + u[b][k]);
                if tag == 3 {
                    springs[k] -= pull;
                    rest[a][k] += 0.5 * pull;
                    rest[b][k] += 0.5 * pull;
                }
            }
        }
        if tag == 1 {
            for vertex in triangle.map(|v| v as usize) {
                (0..3).for_each(|k| rest[vertex][k] -= area / 3.0 * [1.0, 2.0, 0.5][k]);
            }
        }
    }
    let on = |surface: i32| -> [f64; 3] {
        let x = if surface == 1 { 0.0 } else { 2.0 };
        let there = mesh.points().iter().zip(&rest).filter(|(point, _)| point[0] == x);
        there.fold([0.0; 3], |sum, (_, rest)| std::array::from_fn(|k| sum[k] + rest[k]))
    };
    assert_near(&forces.supports, |support| on([1, 2][support]), 1e-11);
    assert_near(&forces.springs, |_| springs, 1e-12);
    assert_near(&[forces.loads], |_| [1.5, 3.0, 0.75], 1e-12);
}

/// The gradient of a corner's shape function: across the opposite face, towards the corner.
fn shape_gradient(corners: [[f64; 3]; 4], corner: usize) -> [f64; 3] {
    let [a, b, c] = [1, 2, 3].map(|k| corners[(corner + k) % 4]);
    let normal = cross(minus(b, a), minus(c, a));
    let height = dot(normal, minus(corners[corner], a));
    normal.map(|component| component / height)
}

fn area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let normal = cross(minus(b, a), minus(c, a));
    0.5 * dot(normal, normal).sqrt()
}

fn minus(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| p[k] - q[k])
}

fn dot(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|k| p[k] * q[k]).sum()
}

fn cross(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3])
}
