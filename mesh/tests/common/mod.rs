//! Meshes round one vertex or edge, and the local blocks of their matrices.

#![allow(dead_code)] // each test binary uses its part

use nalgebra::DMatrix;
use octruss_mesh::{CheckOptions, Features, Hierarchy, RawMesh, Scheme, TetMesh, check};

/// A mesh from points and tets with the marking as ordered and no features.
///
/// Tets of negative volume are mended by swapping x1 and x3, which keeps their
/// marked pair.
pub fn as_ordered(points: Vec<[f64; 3]>, mut tets: Vec<[u32; 4]>) -> TetMesh {
    for tet in &mut tets {
        if octruss_mesh::reference_tet::six_volumes(tet.map(|v| points[v as usize])) < 0.0 {
            tet.swap(1, 3);
        }
    }
    let regions = vec![0; tets.len()];
    let features = Some(Features::default());
    let raw = RawMesh { points, tets, regions, features, ..RawMesh::default() };
    check(raw, &CheckOptions::default()).expect("a sound mesh").mesh
}

/// The same mesh without creases or corners, its marking as ordered.
pub fn smooth(mesh: TetMesh) -> TetMesh {
    as_ordered(mesh.points().to_vec(), mesh.tets().to_vec())
}

/// A hierarchy over a mesh that carries its features.
pub fn hierarchy(mesh: TetMesh) -> Hierarchy {
    Hierarchy::new(mesh, &Default::default())
}

/// The star of vertex 0 with two poles (1, 2) over `layers` rings of n link
/// vertices, joined by antiprism bands: bipyramid(n) for one layer.
pub fn stack(n: u32, layers: u32) -> TetMesh {
    let ring = |layer: u32, i: u32| 3 + layer * n + i % n;
    let mut points = vec![[0.0; 3], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
    for layer in 0..layers {
        let latitude = std::f64::consts::PI * (f64::from(layer + 1) / f64::from(layers + 1) - 0.5);
        for i in 0..n {
            let turn =
                std::f64::consts::TAU * (f64::from(i) + 0.5 * f64::from(layer)) / f64::from(n);
            points.push([latitude.cos() * turn.cos(), latitude.cos() * turn.sin(), latitude.sin()]);
        }
    }
    let mut tets = Vec::new();
    for i in 0..n {
        tets.push([0, 1, ring(0, i), ring(0, i + 1)]);
        tets.push([0, 2, ring(layers - 1, i), ring(layers - 1, i + 1)]);
        for layer in 1..layers {
            tets.push([0, ring(layer - 1, i), ring(layer - 1, i + 1), ring(layer, i)]);
            tets.push([0, ring(layer, i), ring(layer, i + 1), ring(layer - 1, i + 1)]);
        }
    }
    as_ordered(points, tets)
}

/// How the tets round an edge mark it.
#[derive(Clone, Copy)]
pub enum Marks {
    /// All mark the edge.
    All,
    /// None marks it, and neighbours agree (an even number of tets).
    Alternate,
    /// Each marks A c_i and B c_(i+1): they conflict on every face.
    Twist,
}

/// The ring of k tets round the edge from vertex 0 (A) to vertex 1 (B).
pub fn edge_ring(k: u32, marks: Marks) -> TetMesh {
    let mut points = vec![[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
    points.extend((0..k).map(|i| {
        let turn = std::f64::consts::TAU * f64::from(i) / f64::from(k);
        [turn.cos(), turn.sin(), 0.0]
    }));
    let tet = |i: u32| {
        let (c, d) = (2 + i, 2 + (i + 1) % k);
        match marks {
            Marks::All => [0, c, 1, d],
            Marks::Alternate if i % 2 == 1 => [1, 0, c, d],
            _ => [0, 1, c, d],
        }
    };
    as_ordered(points, (0..k).map(tet).collect())
}

/// The one-ring block of a scheme's matrix at an interior vertex: row 0 its own
/// rule, row i that of the edge to its i-th neighbour; columns likewise.
pub fn one_ring_block(mesh: &TetMesh, vertex: u32, scheme: Scheme) -> DMatrix<f64> {
    let mut levels = hierarchy(mesh.clone());
    levels.subdivide(scheme).expect("one step");
    let (topology, matrix) = (&levels.topologies[0], &levels.refinements[0].matrix);
    let n = mesh.points().len();
    let mut ring = vec![vertex];
    let mut rows = vec![vertex as usize];
    for (edge, &[a, b]) in topology.edges().iter().enumerate() {
        if a == vertex || b == vertex {
            ring.push(a ^ b ^ vertex);
            rows.push(n + edge);
        }
    }
    let mut block = DMatrix::zeros(ring.len(), ring.len());
    for (i, &row) in rows.iter().enumerate() {
        let (columns, weights) = matrix.row(row);
        for (&column, &weight) in columns.iter().zip(weights) {
            let j =
                ring.iter().position(|&v| v == column).expect("a one-ring rule stays in the ring");
            block[(i, j)] = weight;
        }
    }
    block
}

/// The one-ring block at the midpoint of edge 0–1 after one linear split.
pub fn midpoint_block(mesh: TetMesh, scheme: Scheme) -> DMatrix<f64> {
    let mut levels = hierarchy(mesh);
    levels.subdivide(Scheme::Linear).expect("one step");
    let edge = levels.topologies[0].edge_between(0, 1).expect("the edge");
    let midpoint = levels.meshes[0].points().len() as u32 + edge;
    one_ring_block(levels.finest(), midpoint, scheme)
}

/// The moduli of the eigenvalues, largest first.
pub fn moduli(block: &DMatrix<f64>) -> Vec<f64> {
    let mut moduli: Vec<f64> =
        block.complex_eigenvalues().iter().map(|value| value.norm()).collect();
    moduli.sort_by(|a, b| b.total_cmp(a));
    moduli
}

/// Asserts that the largest eigenvalues have these moduli.
pub fn assert_spectrum(block: &DMatrix<f64>, expected: &[f64], tolerance: f64, what: &str) {
    let found = moduli(block);
    for (i, &value) in expected.iter().enumerate() {
        assert!(
            (found[i] - value).abs() <= tolerance,
            "{what}: {i}: {found:?} against {expected:?}"
        );
    }
}
