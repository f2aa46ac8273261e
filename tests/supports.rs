//! Supports along normals from a config, and what a run remarks about them.

mod common;

use common::{octruss, report, stderr};
use octruss_meshio::Dataset;

/// A shaft of radius 1 along z: its mantle in four groups x0 to y1, its ends z0 and z1.
fn shaft() -> Dataset {
    let mut mesh = octruss_mesh::shapes::kuhn_box([4, 4, 4], [2.0, 2.0, 2.0]).into_raw();
    for point in &mut mesh.points {
        let [x, y] = [point[0] - 1.0, point[1] - 1.0];
        let factor = x.abs().max(y.abs()) / x.hypot(y).max(1e-300);
        [point[0], point[1]] = [factor * x, factor * y];
    }
    Dataset { mesh, ..Dataset::default() }
}

const LINEAR: &str = "scheme = \"linear\"";
const SMOOTH: &str = "scheme = \"box-spline\"";

/// The notes of a solve on the shaft, refined so, and what is said on stderr.
fn notes(subdivide: &str, fixed: &str) -> (Vec<String>, String) {
    let folder = tempfile::tempdir().unwrap();
    octruss_meshio::write(&folder.path().join("shaft.vtu"), &shaft()).unwrap();
    let config = format!(
        "name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"shaft.vtu\"\n[[stage]]\n\
         kind = \"check\"\n[[stage]]\nkind = \"subdivide\"\nlevels = 1\n{subdivide}\n\
         [[stage]]\nkind = \"solve\"\nproblem = \"elasticity\"\n\
         material = {{ young = 2.6, poisson = 0.3 }}\nfixed = [{fixed}]\n\
         traction = [{{ surface = \"z1\", value = [\"-y\", \"x\", 0] }}]\n\
         prolongation = [\"linear\"]\n"
    );
    std::fs::write(folder.path().join("c.toml"), config).unwrap();
    let run = octruss(folder.path(), &["run", "c.toml", "--quiet"]);
    assert!(run.status.success(), "{}", stderr(&run));
    let report = report(&folder.path().join("out/c"));
    let notes = report["stages"][3]["notes"].as_array().into_iter().flatten();
    (notes.map(|note| note.as_str().unwrap().into()).collect(), stderr(&run))
}

#[test]
fn flat_facets_of_a_curved_bearing_are_remarked() {
    let clamp = "{ surface = \"z0\", value = [0, 0, 0] }";
    let bearing = format!("{clamp}, {{ surface = \"x0\", normal = 0 }}");
    let (linear, said) = notes(LINEAR, &bearing);
    assert_eq!(linear.len(), 1, "{linear:?}");
    assert!(
        linear[0].starts_with(
            "the surface `x0`, held along its normals, is curved, and refined by the scheme \
             `linear` its facets stay flat"
        ),
        "{linear:?}"
    );
    assert!(said.contains(&linear[0]), "{said}");
    // Smoothly refined it may slide, and planes may in any case.
    assert_eq!(notes(SMOOTH, &bearing).0.len(), 0);
    assert_eq!(notes(LINEAR, &format!("{clamp}, {{ surface = \"z1\", normal = 0 }}")).0.len(), 0);
}

#[test]
fn a_ridge_between_two_halves_of_a_bearing_is_remarked() {
    let halves = "{ surface = \"z0\", value = [0, 0, 0] }, { surface = \"x0\", normal = 0 }, \
                  { surface = \"y0\", normal = 0 }";
    let (ridge, said) = notes(SMOOTH, halves);
    assert_eq!(ridge.len(), 1, "{ridge:?}");
    assert!(
        ridge[0]
            .starts_with("the surfaces `x0` and `y0`, both held along their normals, meet at a")
            && ridge[0].contains("`group-borders = false`"),
        "{ridge:?}"
    );
    assert!(said.contains(&ridge[0]), "{said}");
    let round = format!("{SMOOTH}\ngroup-borders = false");
    assert_eq!(notes(&round, halves).0.len(), 0);
}
