//! Supports along normals from a config, and what a run remarks about them.

mod common;

use common::{octruss, report, stderr};
use octruss_mesh::{Group, RawMesh};
use octruss_meshio::Dataset;
use serde_json::Value;

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

const LINEAR: &str = "levels = 1\nscheme = \"linear\"";
const SMOOTH: &str = "levels = 1\nscheme = \"box-spline\"";

/// The report of a solve on a shaft, refined so, and what is said on stderr.
fn solve(shaft: &Dataset, subdivide: &str, fixed: &str) -> (Value, String) {
    let folder = tempfile::tempdir().unwrap();
    octruss_meshio::write(&folder.path().join("shaft.vtu"), shaft).unwrap();
    let config = format!(
        "name = \"c\"\n[[stage]]\nkind = \"import\"\npath = \"shaft.vtu\"\n[[stage]]\n\
         kind = \"check\"\n[[stage]]\nkind = \"subdivide\"\n{subdivide}\n\
         [[stage]]\nkind = \"solve\"\nproblem = \"elasticity\"\n\
         material = {{ young = 2.6, poisson = 0.3 }}\nfixed = [{fixed}]\n\
         traction = [{{ surface = \"z1\", value = [\"-y\", \"x\", 0] }}]\n\
         prolongation = [\"linear\"]\n"
    );
    std::fs::write(folder.path().join("c.toml"), config).unwrap();
    let run = octruss(folder.path(), &["run", "c.toml", "--quiet"]);
    assert!(run.status.success(), "{}", stderr(&run));
    (report(&folder.path().join("out/c"))["stages"][3].take(), stderr(&run))
}

/// The notes of a solve on the shaft, refined so, and what is said on stderr.
fn notes(subdivide: &str, fixed: &str) -> (Vec<String>, String) {
    let (solve, said) = solve(&shaft(), subdivide, fixed);
    let notes = solve["notes"].as_array().into_iter().flatten();
    (notes.map(|note| note.as_str().unwrap().into()).collect(), said)
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
    let angular = format!("{SMOOTH}\ngroup-borders = true");
    let (ridge, said) = notes(&angular, halves);
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
    assert_eq!(notes(SMOOTH, halves).0.len(), 0);
}

#[test]
fn a_shaft_turns_as_far_whatever_groups_its_bearing_is_made_of() {
    // Its mantle as one group, as four, and as four below and four above.
    let regrouped = |tag: &dyn Fn(i32, f64) -> i32| {
        let mut shaft = shaft();
        let RawMesh { points, triangles, groups, .. } = &mut shaft.mesh;
        for (triangle, of) in triangles.simplices.iter().zip(&mut triangles.tags) {
            let height = triangle.iter().map(|&v| points[v as usize][2]).sum::<f64>() / 3.0;
            *of = tag(*of, height);
        }
        let upper = (1..=4).map(|id| Group { dimension: 2, id: 10 + id, name: format!("u{id}") });
        groups.extend(upper);
        shaft
    };
    let one = regrouped(&|tag, _| if tag <= 4 { 1 } else { tag });
    let eight = regrouped(&|tag, z| if tag <= 4 && z > 1.0 { tag + 10 } else { tag });
    let turned = |shaft: &Dataset, bearing: &[&str]| {
        let bearing =
            bearing.iter().map(|name| format!(", {{ surface = \"{name}\", normal = 0 }}"));
        let clamp = "{ surface = \"z0\", value = [0, 0, 0] }";
        let fixed = clamp.to_string() + &bearing.collect::<String>();
        let (solve, said) = solve(shaft, "levels = 2", &fixed);
        assert!(!said.contains("ridge"), "{said}");
        solve["solves"][0]["maximum"].as_f64().unwrap()
    };
    let whole = turned(&one, &["x0"]);
    // A twist of 1 a unit of length over the length 2; the rounded shaft is thinner, linear
    // tets are too stiff.
    assert!((whole / 2.0 - 1.0).abs() < 0.1, "{whole}");
    let lower = ["x0", "x1", "y0", "y1"];
    let parts = turned(&shaft(), &lower);
    assert!((parts / whole - 1.0).abs() < 0.01, "{parts} for {whole}");
    let all = [&lower[..], &["u1", "u2", "u3", "u4"]].concat();
    let parts = turned(&eight, &all);
    assert!((parts / whole - 1.0).abs() < 0.01, "{parts} for {whole}");
}
