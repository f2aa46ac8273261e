//! Named surroundings of one vertex or one edge, for spectra and tests.
//!
//! All have smooth boundaries and keep the marking as stated. The link of
//! vertex 0 names a star: its vertices are the neighbours, its triangles the
//! faces opposite.

use std::f64::consts::{PI, TAU};

use crate::core::raw_mesh::{Features, RawMesh};
use crate::core::reference_tet::six_volumes;
use crate::core::tet_mesh::TetMesh;

/// The star of vertex 0 with two poles (1, 2) over `layers` rings of `n` link
/// vertices each, joined by bands of an antiprism; on the unit sphere.
///
/// # Panics
/// If `n` is less than 3 or there are no layers.
pub fn stack(n: u32, layers: u32) -> TetMesh {
    assert!(n >= 3 && layers > 0, "a ring needs three vertices, a stack one ring");
    let ring = |layer: u32, i: u32| 3 + layer * n + i % n;
    let mut points = vec![[0.0; 3], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
    for layer in 0..layers {
        let latitude = PI * (f64::from(layer + 1) / f64::from(layers + 1) - 0.5);
        for i in 0..n {
            let turn = TAU * (f64::from(i) + 0.5 * f64::from(layer)) / f64::from(n);
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

/// The star of vertex 0 whose link is two poles over one ring of `n` vertices.
///
/// # Panics
/// If `n` is less than 3.
pub fn bipyramid(n: u32) -> TetMesh {
    stack(n, 1)
}

/// The star of vertex 0 whose link is an octahedron.
pub fn octahedron() -> TetMesh {
    bipyramid(4)
}

/// The star of vertex 0 whose link is an icosahedron.
pub fn icosahedron() -> TetMesh {
    stack(5, 2)
}

/// How the tets round an edge mark their pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marks {
    /// All mark the edge.
    All,
    /// None marks it and neighbours agree; this takes an even number of tets,
    /// for an odd one the last and the first disagree.
    Alternate,
    /// The tet A B c(i) c(i+1) marks A c(i) and B c(i+1): neighbours disagree
    /// on every face.
    Twist,
}

/// The ring of `k` tets round the edge from vertex 0 (A) to vertex 1 (B).
///
/// # Panics
/// If `k` is less than 3.
pub fn edge_ring(k: u32, marks: Marks) -> TetMesh {
    assert!(k >= 3, "at least three tets surround an edge");
    let mut points = vec![[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
    points.extend((0..k).map(|i| {
        let turn = TAU * f64::from(i) / f64::from(k);
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

/// A mesh with the marking as ordered and no features. Tets of negative volume
/// are mended by swapping x1 and x3, which keeps their marked pair.
fn as_ordered(points: Vec<[f64; 3]>, mut tets: Vec<[u32; 4]>) -> TetMesh {
    for tet in &mut tets {
        if six_volumes(tet.map(|v| points[v as usize])) < 0.0 {
            tet.swap(1, 3);
        }
    }
    let regions = vec![0; tets.len()];
    let features = Some(Features::default());
    TetMesh::trusted(RawMesh { points, tets, regions, features, ..RawMesh::default() })
}
