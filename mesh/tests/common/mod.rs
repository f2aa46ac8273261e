//! Meshes with their marking as ordered, and spectra of local matrices.

#![allow(dead_code)] // each test binary uses its part

pub mod bodies;
pub mod limit_body;
pub mod parts;
pub mod random_block;
pub mod random_marks;
pub mod reflected;
pub mod slow_surface;

use octruss_mesh::analysis::{LocalMatrix, at_midpoint};
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

/// The local matrix of a scheme at a vertex.
pub fn at_vertex(mesh: &TetMesh, vertex: u32, scheme: Scheme) -> LocalMatrix {
    LocalMatrix::new(mesh, vertex, scheme).expect("a vertex of the solid")
}

/// The local matrix at the midpoint of edge 0–1.
pub fn on_edge(mesh: &TetMesh, scheme: Scheme) -> LocalMatrix {
    let (split, midpoint) = at_midpoint(mesh, [0, 1]).expect("the edge");
    at_vertex(&split, midpoint, scheme)
}

/// Asserts that the largest eigenvalues have these moduli.
pub fn assert_spectrum(local: &LocalMatrix, expected: &[f64], tolerance: f64, what: &str) {
    let spectrum = local.spectrum().expect("eigenvalues");
    for (i, &value) in expected.iter().enumerate() {
        assert!(
            (spectrum.modulus(i) - value).abs() <= tolerance,
            "{what}: eigenvalue {i}: {:?} against {expected:?}",
            &spectrum.eigenvalues[..spectrum.eigenvalues.len().min(12)]
        );
    }
}
