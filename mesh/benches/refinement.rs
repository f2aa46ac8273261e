//! A subdivision step by scheme and size, its matrix alone and applied, and
//! topology from scratch, in new tets (or tets, or bytes) per second.
//!
//! What each must move at least, per new tet (P1 lattice: 1/6 vertices, 7/6
//! edges and 2 faces a tet): the split writes tets 16, edges 8 · 7/6, first faces
//! 4 · 7/6, faces 12 · 2, face edges 12 · 2, face tets 8 · 2, tet edges 24 and tet
//! faces 16: 134 bytes. The box-spline matrix writes about 6.8 entries of 12 bytes
//! and one offset a fine vertex: 14 bytes a new tet. Its application to points
//! reads the matrix and writes 24 bytes a fine vertex. A copy of memory in the
//! same run tells what the machine can move.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use octruss_mesh::{
    FeatureOptions, RawMesh, Scheme, Step, TetMesh, Topology, guard::usual_floor, prepare, shapes,
    subdivide, subdivision_matrix,
};

/// Cells in each direction: 10⁵, 10⁶ and 10⁷ new tets.
const SIZES: [u32; 3] = [13, 28, 60];

fn block(cells: u32) -> (TetMesh, Topology) {
    let mesh = prepare(shapes::kuhn_cube(cells), &FeatureOptions::default());
    let topology = Topology::new(mesh.raw());
    (mesh, topology)
}

/// Matrix, mesh and topology of one step.
fn steps(c: &mut Criterion) {
    let mut group = c.benchmark_group("step");
    group.sample_size(10);
    for cells in SIZES {
        let (mesh, topology) = block(cells);
        let new_tets = 8 * mesh.tets().len() as u64;
        group.throughput(Throughput::Elements(new_tets));
        let guarded = Step { min_quality: Some(usual_floor(&mesh)), ..Scheme::BoxSpline.into() };
        let mut named: Vec<(String, Step)> = vec![
            ("box-spline with guard".into(), guarded),
            ("linear".into(), Scheme::Linear.into()),
        ];
        // The other schemes at one size: how cost grows is the same for all.
        let of_size = |scheme: &Scheme| *scheme == Scheme::BoxSpline || cells == SIZES[1];
        let schemes = Scheme::ALL.into_iter().skip(1).filter(of_size);
        named.extend(schemes.map(|scheme| (scheme.name().to_string(), scheme.into())));
        for (name, step) in named {
            group.bench_function(BenchmarkId::new(name, new_tets), |b| {
                b.iter(|| subdivide(&mesh, &topology, step, 1).unwrap());
            });
        }
    }
    group.finish();
}

fn matrices(c: &mut Criterion) {
    let mut group = c.benchmark_group("matrix");
    group.sample_size(10);
    let (mesh, topology) = block(SIZES[1]);
    group.throughput(Throughput::Elements(8 * mesh.tets().len() as u64));
    for scheme in Scheme::ALL {
        group.bench_function(scheme.name(), |b| {
            b.iter(|| subdivision_matrix(&mesh, &topology, scheme));
        });
    }
    let (mesh, topology) = block(SIZES[2]);
    let matrix = subdivision_matrix(&mesh, &topology, Scheme::BoxSpline);
    group.throughput(Throughput::Bytes((matrix.bytes() + 24 * matrix.rows()) as u64));
    group
        .bench_function("box-spline applied to points", |b| b.iter(|| matrix.apply(mesh.points())));
    group.finish();
}

fn topologies(c: &mut Criterion) {
    let mut group = c.benchmark_group("topology from scratch");
    group.sample_size(10);
    let ordered = shapes::kuhn_cube(SIZES[2]).into_raw();
    group.throughput(Throughput::Elements(ordered.tets.len() as u64));
    group.bench_function("ordered", |b| b.iter(|| Topology::new(&ordered)));
    let shuffled = shuffled(ordered);
    group.bench_function("shuffled", |b| b.iter(|| Topology::new(&shuffled)));
    group.finish();
}

/// The mesh with its vertices and tets in random order.
fn shuffled(mut mesh: RawMesh) -> RawMesh {
    let mut state = 1u64;
    let mut below = |n: usize| {
        // xorshift64
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as usize % n
    };
    let mut new: Vec<u32> = (0..mesh.points.len() as u32).collect();
    (1..new.len()).rev().for_each(|i| new.swap(i, below(i + 1)));
    (1..mesh.tets.len()).rev().for_each(|i| mesh.tets.swap(i, below(i + 1)));
    let renumbered = mesh.tets.as_flattened_mut().iter_mut();
    let triangles = mesh.triangles.simplices.as_flattened_mut().iter_mut();
    renumbered.chain(triangles).for_each(|v| *v = new[*v as usize]);
    mesh
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

criterion_group!(benches, copy, steps, matrices, topologies);
criterion_main!(benches);
