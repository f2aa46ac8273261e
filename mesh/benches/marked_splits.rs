//! Splitting at marked edges by the size of the mesh and the share of it that is marked,
//! in tets of the new mesh per second: closing the marks, splitting, topology.
//!
//! A step makes the whole mesh anew, copying tets that stay; so its cost goes with the
//! number of tets of the new mesh, not with the number of those that were split.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use octruss_mesh::{
    Diagonal, FeatureOptions, Hierarchy, MarkedEdges, TetMesh, Topology, prepare, shapes,
    split_marked,
};

/// Cells in each direction: new meshes of 3 thousand to 3 million tets.
const SIZES: [u32; 4] = [7, 15, 32, 64];

/// All edges of the tets whose centre is nearer to a corner than this.
fn marked_ball(mesh: &TetMesh, topology: &Topology, radius: f64) -> MarkedEdges {
    let is_near = |tet: &[u32; 4]| {
        let corners = tet.map(|v| mesh.points()[v as usize]);
        let sum = [0, 1, 2].map(|k| corners.iter().map(|p| p[k]).sum::<f64>());
        sum.iter().map(|x| x * x).sum::<f64>().sqrt() < 4.0 * radius
    };
    let tets = (0u32..).zip(mesh.tets()).filter(|(_, tet)| is_near(tet)).map(|(t, _)| t);
    let mut marks = MarkedEdges::new(topology);
    marks.mark_tets(topology, tets);
    marks
}

fn splits(c: &mut Criterion) {
    let mut group = c.benchmark_group("marked split");
    group.sample_size(10);
    for cells in SIZES {
        let mesh = prepare(shapes::kuhn_cube(cells), &FeatureOptions::default());
        // Split once before, so that numbers lie as they do in a hierarchy.
        let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
        let ball = marked_ball(&levels.finest().mesh, &levels.finest().topology, 0.3);
        levels.split_marked(&ball, Diagonal::Inherit).unwrap();
        let finest = levels.finest();
        let (mesh, topology) = (&finest.mesh, &finest.topology);
        let random_edges = || {
            let mut marks = MarkedEdges::new(topology);
            // Every 29th of the numbers, scrambled.
            let edges = 0..topology.edges().len() as u32;
            marks.mark_edges(edges.filter(|&edge| edge.wrapping_mul(2_654_435_761) % 29 == 0));
            marks
        };
        let cases = [
            ("small ball", marked_ball(mesh, topology, 0.1)),
            ("large ball", marked_ball(mesh, topology, 0.5)),
            ("scattered edges", random_edges()),
        ];
        for (name, marks) in cases {
            let split = || split_marked(mesh, topology, &marks, Diagonal::Inherit, 1).unwrap();
            let tets = split().0.tets().len() as u64;
            group.throughput(Throughput::Elements(tets));
            group.bench_function(BenchmarkId::new(name, tets), |b| b.iter(split));
        }
    }
    group.finish();
}

criterion_group!(benches, splits);
criterion_main!(benches);
