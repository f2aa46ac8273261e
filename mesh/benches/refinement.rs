//! The red split with topology, topology from scratch, the matrix and its
//! application, in new tets (or tets, or bytes) per second.
//!
//! What each must move at least, per new tet (P1 lattice: 1/6 vertices, 7/6
//! edges and 2 faces a tet): the split writes tets 16, edges 8 · 7/6, faces 12 · 2,
//! face edges 12 · 2, face tets 8 · 2, tet edges 24 and tet faces 16: 129 bytes. The
//! box-spline matrix writes about 6.8 entries of 12 bytes and one offset a fine
//! vertex: 14 bytes a new tet. Its application to points reads the matrix and
//! writes 24 bytes a fine vertex. A copy of memory in the same run tells what
//! the machine can move.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use octruss_mesh::{
    FeatureOptions, Scheme, Topology, prepare, shapes, subdivide, subdivision_matrix,
};

fn refinement(c: &mut Criterion) {
    let mut group = c.benchmark_group("refinement");
    group.sample_size(10);
    for cells in [16u32, 28] {
        let mesh = prepare(shapes::kuhn_cube(cells), &FeatureOptions::default());
        let topology = Topology::new(mesh.raw());
        let tets = mesh.tets().len() as u64;
        group.throughput(Throughput::Elements(8 * tets));
        for scheme in [Scheme::Linear, Scheme::BoxSpline] {
            let id = BenchmarkId::new(format!("split {}", scheme.name()), 8 * tets);
            group
                .bench_function(id, |b| b.iter(|| subdivide(&mesh, &topology, scheme, 1).unwrap()));
        }
        let id = BenchmarkId::new("box-spline matrix", 8 * tets);
        group.bench_function(id, |b| {
            b.iter(|| subdivision_matrix(&mesh, &topology, Scheme::BoxSpline))
        });
        let matrix = subdivision_matrix(&mesh, &topology, Scheme::BoxSpline);
        group.throughput(Throughput::Bytes((matrix.bytes() + 24 * matrix.rows()) as u64));
        let id = BenchmarkId::new("apply to points", 8 * tets);
        group.bench_function(id, |b| b.iter(|| matrix.apply(mesh.points())));
        group.throughput(Throughput::Elements(tets));
        group.bench_function(BenchmarkId::new("topology from scratch", tets), |b| {
            b.iter(|| Topology::new(mesh.raw()))
        });
    }
    group.finish();
}

fn copy(c: &mut Criterion) {
    let source = vec![1u8; 256 << 20];
    let mut target = vec![0u8; source.len()];
    let mut group = c.benchmark_group("machine");
    group.sample_size(10);
    // A copy reads and writes each byte.
    group.throughput(Throughput::Bytes(2 * source.len() as u64));
    group.bench_function("copy", |b| b.iter(|| target.copy_from_slice(&source)));
    group.finish();
}

criterion_group!(benches, copy, refinement);
criterion_main!(benches);
