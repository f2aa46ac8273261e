//! Writing and reading a VTU file of 196,608 tets, in bytes of the file a second.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use octruss_mesh::shapes;
use octruss_meshio::vtu::{self, Compression, VtuOptions};
use octruss_meshio::{Dataset, Field, read};

fn vtu_files(criterion: &mut Criterion) {
    let mesh = shapes::kuhn_cube(32).into_raw();
    let heights = mesh.points.iter().map(|p| p[2] * p[0].sin()).collect();
    let quality = (0..mesh.tets.len()).map(|tet| 1.0 / (tet + 1) as f64).collect();
    let dataset = Dataset {
        mesh,
        point_fields: vec![Field::scalar("u", heights)],
        cell_fields: vec![Field::scalar("quality", quality)],
        ..Dataset::default()
    };
    let folder = tempfile::tempdir().expect("a folder to write in");
    let mut group = criterion.benchmark_group("vtu");
    for (name, compression) in [("raw", Compression::None), ("zlib 1", Compression::Zlib(1))] {
        let path = folder.path().join(name).with_extension("vtu");
        let options = VtuOptions { compression };
        let write = || vtu::write_with(&path, &dataset, &options).expect("the file is written");
        write();
        let bytes = std::fs::metadata(&path).expect("the file is there").len();
        group.throughput(Throughput::Bytes(bytes));
        group.bench_function(format!("write {name}"), |bencher| bencher.iter(write));
        group.bench_function(format!("read {name}"), |bencher| {
            bencher.iter(|| read(&path).expect("the file is read"));
        });
    }
    group.finish();
}

criterion_group!(benches, vtu_files);
criterion_main!(benches);
