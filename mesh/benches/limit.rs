//! Limit surfaces: positions and all that is known of a point on one core, and
//! the masks of all vertices, on surfaces and inside, on all cores.

use std::f64::consts::TAU;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use octruss_mesh::analysis::{solid_limit_matrix, stars};
use octruss_mesh::limit::surface::{LimitSurface, Place};
use octruss_mesh::reference_tet::six_volumes;
use octruss_mesh::{
    CheckOptions, FeatureOptions, RawMesh, Scheme, Strata, TetMesh, Topology, check, prepare,
    shapes,
};

/// A ring with teeth: blocks of a polar grid, each split into six tets.
fn gear(teeth: usize, layers: usize) -> TetMesh {
    let (turns, rings) = (4 * teeth, 3);
    let number = |i: usize, j: usize, k: usize| ((k * (rings + 1) + j) * turns + i % turns) as u32;
    let mut points = Vec::new();
    for k in 0..=layers {
        for j in 0..=rings {
            for i in 0..turns {
                let is_tooth = j == rings && i % 4 < 2;
                let radius = 2.0 + j as f64 / 3.0 + if is_tooth { 0.4 } else { 0.0 };
                let (sine, cosine) = (TAU * i as f64 / turns as f64).sin_cos();
                points.push([radius * cosine, radius * sine, k as f64 / layers as f64]);
            }
        }
    }
    let mut tets = Vec::new();
    for (i, j, k) in
        (0..turns).flat_map(|i| (0..rings).flat_map(move |j| (0..layers).map(move |k| (i, j, k))))
    {
        for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]] {
            let mut at = [i, j, k];
            let mut tet = [number(i, j, k); 4];
            for (corner, axis) in order.into_iter().enumerate() {
                at[axis] += 1;
                tet[corner + 1] = number(at[0], at[1], at[2]);
            }
            if six_volumes(tet.map(|v| points[v as usize])) < 0.0 {
                tet.swap(1, 3);
            }
            tets.push(tet);
        }
    }
    let regions = vec![0; tets.len()];
    let raw = RawMesh { points, tets, regions, ..RawMesh::default() };
    let mesh = check(raw, &CheckOptions::default()).expect("a sound mesh").mesh;
    prepare(mesh, &FeatureOptions::default())
}

fn bodies() -> [(&'static str, TetMesh); 3] {
    let smooth = FeatureOptions { crease_angle: 40.0, ..FeatureOptions::default() };
    [
        ("block", prepare(shapes::kuhn_cube(12), &smooth)),
        ("gear", gear(24, 4)),
        ("icosahedron", stars::icosahedron()),
    ]
}

/// Places all over the surface, as random as numbers by a fixed step are.
fn places(topology: &Topology, strata: &Strata, count: usize) -> Vec<Place> {
    let faces: Vec<u32> =
        (0..topology.faces().len() as u32).filter(|&f| strata.is_surface[f as usize]).collect();
    let fraction = |i: usize, step: f64| (i as f64 * step).fract();
    let place = |i: usize| {
        let (u, v) = (fraction(i, 0.754_877_666_246_692_7), fraction(i, 0.569_840_290_998_053_2));
        (faces[i % faces.len()], if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] })
    };
    (0..count).map(place).collect()
}

fn limits(c: &mut Criterion) {
    for (name, mesh) in bodies() {
        let topology = Topology::new(mesh.raw());
        let features = mesh.features().cloned().unwrap_or_default();
        let strata = Strata::new(mesh.raw(), &topology, &features);
        let surface = LimitSurface::new(mesh.raw(), &topology, &strata, mesh.points()).unwrap();
        let places = places(&topology, &strata, 100_000);
        let mut group = c.benchmark_group(name);
        group.sample_size(10);
        group.throughput(Throughput::Elements(places.len() as u64));
        let each = |at: &dyn Fn(Place)| places.iter().for_each(|&place| at(place));
        group.bench_function("position, one core", |b| {
            b.iter(|| each(&|place| drop(std::hint::black_box(surface.position(place)))));
        });
        group.bench_function("all, one core", |b| {
            b.iter(|| each(&|place| drop(std::hint::black_box(surface.evaluate(place)))));
        });
        group.bench_function("positions, all cores", |b| b.iter(|| surface.positions(&places)));
        group.finish();
    }
}

fn vertices(c: &mut Criterion) {
    let mesh = prepare(shapes::kuhn_cube(60), &FeatureOptions::default());
    let topology = Topology::new(mesh.raw());
    let strata = Strata::new(mesh.raw(), &topology, mesh.features().unwrap());
    let surface = LimitSurface::new(mesh.raw(), &topology, &strata, mesh.points()).unwrap();
    let mut group = c.benchmark_group("vertices");
    group.sample_size(10);
    group.throughput(Throughput::Elements(surface.sector_limits().len() as u64));
    group.bench_function("masks", |b| b.iter(|| surface.sector_limits()));
    group.bench_function("sectors", |b| {
        b.iter(|| LimitSurface::new(mesh.raw(), &topology, &strata, mesh.points()));
    });
    group.finish();
}

fn solids(c: &mut Criterion) {
    let mut group = c.benchmark_group("solid");
    group.sample_size(10);
    for (name, mesh) in [("regular", shapes::kuhn_cube(30)), ("irregular", irregular())] {
        let topology = Topology::new(mesh.raw());
        group.throughput(Throughput::Elements(mesh.points().len() as u64));
        group.bench_function(name, |b| {
            b.iter(|| solid_limit_matrix(&mesh, &topology, Scheme::BoxSpline));
        });
    }
    group.finish();
}

/// Blocks of five tets, where no vertex inside is regular.
fn irregular() -> TetMesh {
    let n = 30;
    let number = |at: [u32; 3]| (at[2] * (n + 1) + at[1]) * (n + 1) + at[0];
    let places =
        || (0..=n).flat_map(move |k| (0..=n).flat_map(move |j| (0..=n).map(move |i| [i, j, k])));
    let points = places().map(|at| at.map(f64::from)).collect();
    let mut tets = Vec::new();
    for at in places().filter(|at| at.iter().all(|&x| x < n)) {
        // Neighbours are mirror images of each other.
        let mirror = (at[0] + at[1] + at[2]) % 2;
        for tet in [[0, 6, 5, 3], [1, 0, 5, 3], [2, 0, 3, 6], [4, 0, 6, 5], [7, 3, 5, 6]] {
            let corner = |v: u32| {
                number([at[0] + ((v ^ mirror) & 1), at[1] + (v >> 1 & 1), at[2] + (v >> 2)])
            };
            let mut tet = tet.map(corner);
            if mirror == 1 {
                tet.swap(1, 3);
            }
            tets.push(tet);
        }
    }
    let regions = vec![0; tets.len()];
    let raw = RawMesh { points, tets, regions, ..RawMesh::default() };
    check(raw, &CheckOptions::default()).expect("a sound mesh").mesh
}

criterion_group!(benches, limits, vertices, solids);
criterion_main!(benches);
