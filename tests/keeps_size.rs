//! Bodies of known size keep it where the smooth surface passes through the input, and so
//! does the shape of their tets.

use std::path::Path;

use octruss_mesh::guard::usual_floor;
use octruss_mesh::quality::mean_ratio_range;
use octruss_mesh::{CheckOptions, FeatureOptions, Hierarchy, Scheme, Step, TetMesh, check};
use octruss_meshio::read;
use std::f64::consts::PI;

fn mesh(name: &str) -> TetMesh {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/meshes").join(name);
    check(read(&path).unwrap().mesh, &CheckOptions::default()).unwrap().mesh
}

fn volume(mesh: &TetMesh) -> f64 {
    (0..mesh.tets().len()).map(|tet| mesh.volume(tet)).sum()
}

/// Two levels; volume over the input's, least η over the input's.
fn refined(mesh: TetMesh, interpolate: bool) -> (f64, f64) {
    let step =
        Step { interpolate, min_quality: Some(usual_floor(&mesh)), ..Scheme::BoxSpline.into() };
    let mut levels = Hierarchy::new(mesh, &FeatureOptions::default());
    (0..2).for_each(|_| levels.subdivide(step).unwrap());
    let eta = |mesh: &TetMesh| mean_ratio_range(mesh.raw()).0;
    let [first, last] = [levels.coarsest(), levels.finest()].map(|level| &level.mesh);
    (volume(last), eta(last) / eta(first))
}

#[test]
fn volumes_are_those_of_the_geometry() {
    // The plate of 20 by 20 with its hole of radius 2.5, by its own symmetry a quarter of it;
    // the others as their .geo files have them.
    let bodies = [
        ("ball.msh", 4.0 / 3.0 * PI, 7e-3),
        ("thick-sphere.msh", (8.0 - 1.0) * PI / 6.0, 3e-3),
        ("pipe.msh", 0.1 * (4.0 - 1.0) * PI / 4.0, 3e-3),
        ("bracket.msh", 92_949.485_351_294_61, 3e-3),
        ("l-bracket.msh", 2.869_964_654_589_221_5, 3e-3),
        ("holed-plate.msh", 393.716_814_692_820_3, 3e-3),
    ];
    for (name, exact, allowed) in bodies {
        let (through, quality) = refined(mesh(name), true);
        let error = (through / exact - 1.0).abs();
        assert!(error < allowed, "{name}: {error:e}");
        assert!(quality >= 0.5, "{name}: {quality}");
        // The published scheme closes in on holes and rounds off what is round.
        let (plain, _) = refined(mesh(name), false);
        assert!((plain / exact - 1.0).abs() > error, "{name}: {plain}");
    }
}

#[test]
fn a_coarse_torus_is_reported_rather_than_kept() {
    // Four facets round its tube meet at more than 40°: they stay flat.
    let (through, quality) = refined(mesh("torus.msh"), true);
    let exact = 2.0 * PI * PI * 0.45 * 0.45;
    assert!((0.85..0.95).contains(&(through / exact)) && quality >= 0.5, "{through} {quality}");
}
