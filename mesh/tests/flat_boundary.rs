//! The quality that the box splines keep where the boundary stays flat.

use octruss_mesh::{
    CheckOptions, FeatureOptions, Hierarchy, Scheme, TetMesh, Topology, check, prepare, quality,
    shapes,
};

/// The same mesh with every boundary edge a crease: the boundary is then split
/// at midpoints and its vertices stay.
fn with_flat_boundary(mesh: &TetMesh) -> TetMesh {
    let topology = Topology::new(mesh.raw());
    let mut raw = mesh.raw().clone();
    let boundary = (0..topology.faces().len()).filter(|&face| topology.is_boundary(face));
    let edges = boundary.flat_map(|face| topology.face_edges()[face]);
    let mut creases: Vec<[u32; 2]> = edges.map(|e| topology.edges()[e as usize]).collect();
    creases.sort_unstable();
    creases.dedup();
    raw.features.as_mut().expect("a prepared mesh").creases = creases;
    check(raw, &CheckOptions::default()).unwrap().mesh
}

/// The smallest η of each level.
fn smallest_over_levels(start: TetMesh, levels: usize) -> Vec<f64> {
    let mut mesh = prepare(start, &FeatureOptions::default());
    let mut smallest = Vec::new();
    for _ in 0..levels {
        let mut step = Hierarchy::new(with_flat_boundary(&mesh), &FeatureOptions::default());
        step.subdivide(Scheme::BoxSpline).unwrap();
        mesh = step.into_finest().mesh;
        smallest.push(quality::smallest_mean_ratio(mesh.raw()));
    }
    smallest
}

#[test]
fn tets_inside_a_flat_boundary_keep_their_quality_without_a_guard() {
    for (start, bound) in [(shapes::regular_tet(), 0.74), (shapes::five_tet_cube(), 0.56)] {
        let smallest = smallest_over_levels(start, 4);
        assert!(smallest.iter().all(|&eta| eta >= bound), "{smallest:?}");
    }
}
