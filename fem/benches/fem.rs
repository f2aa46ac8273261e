//! Throughput of assembly, matrix and Galerkin products, set-up and V-cycle on the
//! unit cube, for numbers and for 3 × 3 blocks.
//!
//! Least bytes that each must move, for n unknowns and m nonzeros:
//! - assembly: 48 a tet (vertices, edges, region), 8 an edge for its sum, 32 a
//!   vertex (point, load), 12 m for the matrix; of elasticity 72 an edge, 48 a
//!   vertex, 76 m;
//! - product: 12 m and 16 n in double, 8 m and 8 n in single precision; with blocks
//!   76 m and 48 n, 40 m and 24 n;
//! - Galerkin product: 12 a nonzero of A, P, Pᵀ and the coarse matrix, which is
//!   written twice;
//! - V(1,1) with Chebyshev of degree K in single precision: 2 K passes over
//!   each matrix at 8 m, and over its vectors at 24 n; twice 8 a nonzero of P;
//! - V(1,1) of blocks with hybrid Gauss–Seidel: two passes over half of each matrix at
//!   40 m, over what couples domains at 44, and over vectors at 96 n.

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use octruss_fem::*;
use octruss_mesh::shapes::kuhn_cube;
use octruss_mesh::{FeatureOptions, Hierarchy, Level, Scheme, linear_matrix};
use octruss_solver::*;
use std::hint::black_box;

/// 48³ cells: 663,552 tets, 103,823 unknowns.
fn hierarchy() -> Hierarchy {
    let mut hierarchy = Hierarchy::new(kuhn_cube(6), &FeatureOptions::default());
    for _ in 0..3 {
        hierarchy.subdivide(Scheme::Linear).unwrap();
    }
    hierarchy
}

fn zero_on_all_sides() -> Vec<(i32, Scalar)> {
    (1..=6).map(|side| (side, 0.0.into())).collect()
}

fn prolongations(hierarchy: &Hierarchy) -> Vec<Csr<f64>> {
    let dofs: Vec<Dofs> = hierarchy
        .levels()
        .iter()
        .map(|level| Dofs::new(&level.mesh, &zero_on_all_sides()).unwrap())
        .collect();
    let prolongation = |level: usize| {
        let matrix = linear_matrix(&hierarchy.levels()[level].topology);
        restrict_to_free(&matrix, &dofs[level + 1], &dofs[level]).unwrap()
    };
    (0..hierarchy.transfers()).map(prolongation).collect()
}

fn benchmarks(criterion: &mut Criterion) {
    let hierarchy = hierarchy();
    let Level { mesh, topology, .. } = hierarchy.finest();
    let problem = Poisson { source: 1.0.into(), fixed: zero_on_all_sides(), ..Poisson::default() };
    let system = assemble(mesh, topology, &problem).unwrap();
    let prolongations = prolongations(&hierarchy);

    let mut group = criterion.benchmark_group("solver");
    group.sample_size(20);
    group.throughput(Throughput::Elements(mesh.tets().len() as u64));
    group.bench_function("assembly (tets)", |bencher| {
        bencher.iter(|| assemble(mesh, topology, black_box(&problem)).unwrap());
    });

    let problem = Elasticity {
        gravity: vector([0.0, 0.0, -9.81]),
        supports: vec![Support { surface: 1, held: Held::displacement([0.0; 3]) }],
        ..Elasticity::new(Material { density: 1.0.into(), ..Material::new(1.0, 0.3) })
    };
    group.bench_function("assembly of elasticity (tets)", |bencher| {
        bencher.iter(|| assemble_elasticity(mesh, topology, black_box(&problem)).unwrap());
    });

    algebra("numbers", &mut group, &system.matrix, &prolongations);
    // The pattern of elasticity on the same mesh, with I + ones times each number:
    // what the numbers are does not change the speed.
    let block = |v: &f64| [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { 2.0 * v } else { *v }));
    let matrix = &system.matrix;
    let offsets = (0..=matrix.rows()).map(|row| matrix.offset(row)).collect();
    let values: Vec<[[f64; 3]; 3]> = matrix.values().iter().map(block).collect();
    let blocks = Csr::new(matrix.columns(), offsets, matrix.indices().to_vec(), values).unwrap();
    algebra("blocks", &mut group, &blocks, &prolongations);
    group.finish();
}

/// Products, set-up and cycle for one kind of entries. What each kernel of the cycle
/// moves and how fast is printed once, beside the copy bandwidth of the same run.
fn algebra<E: SystemEntry>(
    kind: &str,
    group: &mut BenchmarkGroup<'_, WallTime>,
    matrix: &Csr<E>,
    prolongations: &[Csr<f64>],
) {
    let size = <E::Nodal as Nodal>::SIZE;
    let numbers = noise(matrix.rows() * size, 1);
    let mut x = vec![E::Nodal::default(); matrix.rows()];
    E::Nodal::flat_mut(&mut x).copy_from_slice(&numbers);
    let mut y = x.clone();
    group.throughput(Throughput::Bytes((matrix.bytes() + 2 * size_of_val(&*x)) as u64));
    group.bench_function(format!("{kind}: product (bytes)"), |bencher| {
        bencher.iter(|| kernels::product(matrix, &x, &mut y));
    });
    group.throughput(Throughput::Elements((matrix.rows() * size) as u64));
    let transposed = transpose(&prolongations[0]);
    group.bench_function(format!("{kind}: Galerkin product (fine unknowns)"), |bencher| {
        bencher.iter(|| galerkin(matrix, &prolongations[0], &transposed));
    });
    let options = MultigridOptions::default();
    let build = || Multigrid::new(matrix, prolongations.to_vec(), &options).unwrap();
    group.bench_function(format!("{kind}: set-up (unknowns)"), |bencher| bencher.iter(build));
    let mut multigrid = build();
    group.bench_function(format!("{kind}: V-cycle (unknowns)"), |bencher| {
        bencher.iter(|| multigrid.apply(&x, &mut y));
    });
    let traffic = multigrid.traffic(11);
    println!("{kind}: a V-cycle, kernel by kernel\n{traffic}\n");
    group.throughput(Throughput::Bytes(traffic.cycle.bytes as u64));
    group.bench_function(format!("{kind}: V-cycle (bytes)"), |bencher| {
        bencher.iter(|| multigrid.apply(&x, &mut y));
    });
}

criterion_group!(benches, benchmarks);
criterion_main!(benches);
