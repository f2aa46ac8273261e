//! Meshes for tests of assembly, and a plain solver for elasticity.

#![allow(dead_code, reason = "each test program uses its own part")]

use octruss_fem::*;
use octruss_mesh::shapes::{kuhn_box, kuhn_cube};
use octruss_mesh::{RawMesh, TetMesh, Topology, check};
use octruss_solver::*;

/// The displacement of an assembled problem.
pub fn solve(mesh: &TetMesh, problem: &Elasticity) -> Vec<[f64; 3]> {
    let topology = Topology::new(mesh.raw());
    let system = assemble_elasticity(mesh, &topology, problem).unwrap();
    solve_system(&system)
}

/// Small systems by a direct solver to the last digits, larger ones by conjugate
/// gradients with the inverse diagonal to 1e-10.
pub fn solve_system(system: &VectorSystem) -> Vec<[f64; 3]> {
    let matrix = scalar_matrix(&system.matrix);
    let rhs = system.rhs.as_flattened();
    let x = if matrix.rows() < 3_000 {
        let options = MultigridOptions { precision: Some(Precision::Double), ..Default::default() };
        let mut direct = Multigrid::new(&matrix, vec![], &options).unwrap();
        // As far as rounding allows.
        let goal = SolveOptions { tolerance: 1e-15, ..Default::default() };
        let (x, report) = conjugate_gradients(&matrix, rhs, &mut direct, &goal).unwrap();
        assert!(report.relative_residual <= 1e-8);
        x
    } else {
        let diagonal = (0..matrix.rows()).map(|i| matrix.get(i, i).unwrap()).collect();
        let goal = SolveOptions { tolerance: 1e-10, max_iterations: 20_000, ..Default::default() };
        conjugate_gradients(&matrix, rhs, &mut Diagonal(diagonal), &goal).unwrap().0
    };
    system.expand(x.as_chunks().0).unwrap()
}

struct Diagonal(Vec<f64>);

impl Preconditioner for Diagonal {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        z.iter_mut().zip(r.iter().zip(&self.0)).for_each(|(z, (r, d))| *z = r / d);
    }
}

/// The same matrix without blocks.
pub fn scalar_matrix(blocks: &Csr<[[f64; 3]; 3]>) -> Csr<f64> {
    let (mut offsets, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
    for row in 0..blocks.rows() {
        let (columns, blocks) = blocks.row(row);
        for i in 0..3 {
            for (&column, block) in columns.iter().zip(blocks) {
                indices.extend([0, 1, 2].map(|j| 3 * column + j));
                values.extend(block[i]);
            }
            offsets.push(indices.len());
        }
    }
    Csr::new(3 * blocks.columns(), offsets, indices, values).unwrap()
}

pub fn checked(raw: RawMesh) -> TetMesh {
    check(raw, &Default::default()).unwrap().mesh
}

/// A box whose inner vertices are moved about, so that no two tets are alike.
pub fn uneven_box(cells: [u32; 3], size: [f64; 3]) -> TetMesh {
    let mut raw = kuhn_box(cells, size).into_raw();
    let step: [f64; 3] = std::array::from_fn(|k| size[k] / f64::from(cells[k]));
    for (n, point) in raw.points.iter_mut().enumerate() {
        for k in 0..3 {
            if point[k] > 1e-9 && point[k] < size[k] - 1e-9 {
                point[k] += 0.15 * step[k] * (7.0 * n as f64 + 2.0 * k as f64).sin();
            }
        }
    }
    checked(raw)
}

pub const SYMMETRY: [i32; 3] = [1, 3, 5];
pub const INNER: i32 = 7;
pub const OUTER: i32 = 8;

/// The octant of a shell with the radii 1 and 2, `layers` layers of tets: a cube
/// less its inner half, each point moved out of the cube of its largest coordinate
/// onto the sphere. Planes of symmetry are 1, 3 and 5, the spheres 7 and 8.
pub fn thick_sphere(layers: u32) -> TetMesh {
    let cube = kuhn_cube(2 * layers);
    let largest = |p: &[f64; 3]| p.iter().copied().fold(0.0, f64::max);
    let is_outside = |tet: &&[u32; 4]| {
        let middle: [f64; 3] = std::array::from_fn(|k| {
            tet.iter().map(|&v| cube.points()[v as usize][k]).sum::<f64>() / 4.0
        });
        largest(&middle) > 0.5
    };
    let tets: Vec<[u32; 4]> = cube.tets().iter().filter(is_outside).copied().collect();
    let mut numbers = vec![u32::MAX; cube.points().len()];
    let mut raw = RawMesh::default();
    for &vertex in tets.as_flattened() {
        if numbers[vertex as usize] == u32::MAX {
            numbers[vertex as usize] = raw.points.len() as u32;
            raw.points.push(cube.points()[vertex as usize]);
        }
    }
    raw.tets = tets.iter().map(|tet| tet.map(|v| numbers[v as usize])).collect();
    raw.regions = vec![0; tets.len()];
    let topology = Topology::new(&raw);
    for face in (0..topology.faces().len()).filter(|&face| topology.is_boundary(face)) {
        let triangle = topology.faces()[face];
        let corners = triangle.map(|v| raw.points[v as usize]);
        let plane = (0..3).find(|&k| corners.iter().all(|p| p[k] == 0.0));
        let is_outer = corners.iter().all(|p| largest(p) == 1.0);
        let sphere = if is_outer { OUTER } else { INNER };
        raw.triangles.push(triangle, plane.map_or(sphere, |k| SYMMETRY[k]));
    }
    for point in &mut raw.points {
        let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
        let factor = 2.0 * largest(point) / length;
        *point = point.map(|x| factor * x);
    }
    checked(raw)
}

/// Supports that let the sides with these tags slide.
pub fn sliding(surfaces: &[i32]) -> Vec<Support> {
    let slide = |&surface: &i32| Support { surface, held: Held::Normal(0.0.into()) };
    surfaces.iter().map(slide).collect()
}

/// ‖u_h − u‖ and ‖∇(u_h − u)‖ in L², over all components.
pub fn errors(
    mesh: &TetMesh,
    u_h: &[[f64; 3]],
    u: impl Fn([f64; 3]) -> [f64; 3] + Sync,
    gradient: impl Fn([f64; 3]) -> [[f64; 3]; 3] + Sync,
) -> [f64; 2] {
    let mut squares = [0.0; 2];
    for k in 0..3 {
        let component: Vec<f64> = u_h.iter().map(|u| u[k]).collect();
        squares[0] += l2_error(mesh, &component, |p| u(p)[k]).powi(2);
        squares[1] += h1_seminorm_error(mesh, &component, |p| gradient(p)[k]).powi(2);
    }
    squares.map(f64::sqrt)
}

/// The boundary triangles of a mesh under tag 1, for shapes without tags.
pub fn with_tagged_boundary(mesh: TetMesh) -> TetMesh {
    let topology = Topology::new(mesh.raw());
    let mut raw = mesh.into_raw();
    for face in (0..topology.faces().len()).filter(|&f| topology.is_boundary(f)) {
        raw.triangles.push(topology.faces()[face], 1);
    }
    checked(raw)
}

/// The tet of the origin and the unit vectors, its region 4, with the face opposite
/// the origin tagged 10 and that in the plane x = 0 tagged 11.
pub fn unit_tet() -> TetMesh {
    let mut raw = RawMesh {
        points: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        tets: vec![[0, 1, 2, 3]],
        regions: vec![4],
        ..RawMesh::default()
    };
    raw.triangles.push([1, 2, 3], 10);
    raw.triangles.push([0, 2, 3], 11);
    checked(raw)
}

/// The displacement x ↦ A x + b.
pub const AFFINE: ([[f64; 3]; 3], [f64; 3]) =
    ([[0.3, -0.2, 0.5], [0.1, 0.4, -0.6], [-0.7, 0.2, 0.1]], [1.0, -2.0, 0.5]);

pub fn affine([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (a, b) = AFFINE;
    std::array::from_fn(|i| a[i][0] * x + a[i][1] * y + a[i][2] * z + b[i])
}

pub fn affine_support(surface: i32) -> Support {
    let component = |k: usize| Some(Scalar::function(move |p| affine(p)[k]));
    Support { surface, held: Held::Components([0, 1, 2].map(component)) }
}

pub fn assert_near<const K: usize>(
    found: &[[f64; K]],
    exact: impl Fn(usize) -> [f64; K],
    bound: f64,
) {
    for (n, found) in found.iter().enumerate() {
        for (found, exact) in found.iter().zip(exact(n)) {
            assert!((found - exact).abs() <= bound, "{n}: {found} for {exact}");
        }
    }
}
