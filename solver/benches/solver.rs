//! Throughput of assembly, Galerkin product and V-cycle on the unit cube.
//!
//! Least bytes that each must move, for n unknowns and m nonzeros:
//! - assembly: 48 a tet (vertices, edges, region), 8 an edge for its sum, 32 a
//!   vertex (point, load), 12 m for the matrix; of elasticity 72 an edge, 48 a
//!   vertex, 76 m;
//! - Galerkin product: 12 a nonzero of A, P, Pᵀ and the coarse matrix, and 24
//!   for each of A P, which is written and read;
//! - V(1,1) with Chebyshev of degree K in single precision: 2 K passes over
//!   each matrix at 8 m, and over its vectors at 24 n; twice 8 a nonzero of P.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use octruss_mesh::shapes::kuhn_cube;
use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, linear_matrix};
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
        .meshes
        .iter()
        .map(|mesh| Dofs::new(mesh, &zero_on_all_sides()).unwrap())
        .collect();
    let prolongation = |level: usize| {
        let matrix = linear_matrix(&hierarchy.topologies[level]);
        restrict_to_free(&matrix, &dofs[level + 1], &dofs[level]).unwrap()
    };
    (0..hierarchy.refinements.len()).rev().map(prolongation).collect()
}

fn benchmarks(criterion: &mut Criterion) {
    let hierarchy = hierarchy();
    let (mesh, topology) = (hierarchy.finest(), hierarchy.topologies.last().unwrap());
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

    let transposed = transpose(&prolongations[0]);
    let unknowns = system.matrix.rows() as u64;
    group.throughput(Throughput::Elements(unknowns));
    group.bench_function("Galerkin product (fine unknowns)", |bencher| {
        bencher.iter(|| galerkin(&system.matrix, &prolongations[0], &transposed));
    });

    let options = MultigridOptions::default();
    let mut multigrid = Multigrid::new(&system.matrix, prolongations, &options).unwrap();
    let residual = noise(system.matrix.rows(), 1);
    let mut correction = vec![0.0; residual.len()];
    group.bench_function("V-cycle (unknowns)", |bencher| {
        bencher.iter(|| multigrid.apply(&residual, &mut correction));
    });
    group.throughput(Throughput::Bytes(cycle_bytes(&multigrid)));
    group.bench_function("V-cycle (least bytes)", |bencher| {
        bencher.iter(|| multigrid.apply(&residual, &mut correction));
    });
    group.finish();
}

/// The least bytes of a V(1,1) cycle of degree 3: see the top of the file.
fn cycle_bytes(multigrid: &Multigrid) -> u64 {
    let level = |level: &LevelSummary| {
        level.prolongation_nonzeros.map_or(0, |prolongation| {
            6 * (8 * level.nonzeros + 24 * level.unknowns) + 16 * prolongation
        })
    };
    multigrid.levels().iter().map(level).sum::<usize>() as u64
}

criterion_group!(benches, benchmarks);
criterion_main!(benches);
