//! Elasticity from a config: what is refused, what is reported, what is written.

mod common;

use std::path::Path;

use common::{code, octruss, report, sample, stderr, succeed};
use octruss_meshio::{Dataset, Values};

/// A unit cube that slides on three planes and is pulled along x; for a line to
/// be spoilt. Line numbers count.
const GOOD: &str = r#"name = "good"
[[stage]]
kind = "import"
path = "MESH"
[[stage]]
kind = "check"
[[stage]]
kind = "subdivide"
levels = 1
scheme = "box-spline"
[[stage]]
kind = "solve"
problem = "elasticity"
material = { young = 200, poisson = 0.3 }
fixed = [{ surface = "x0", normal = 0 }, { surface = "y0", y = 0 }, { surface = "z0", z = 0 }]
traction = [{ surface = "x1", value = [4, 0, 0] }]
[[stage]]
kind = "write"
levels = false
"#;

fn write_config(folder: &Path, text: &str) {
    let mesh = sample("cube.msh").display().to_string();
    std::fs::write(folder.join("c.toml"), text.replace("MESH", &mesh)).unwrap();
}

/// The fields that a config writes, and its report.
fn run(text: &str) -> (Dataset, serde_json::Value) {
    let folder = tempfile::tempdir().unwrap();
    write_config(folder.path(), text);
    succeed(folder.path(), &["run", "c.toml", "--out", "out"]);
    let solution = octruss_meshio::read(&folder.path().join("out/solution.vtu")).unwrap();
    let report = report(&folder.path().join("out"));
    let stages = report["stages"].as_array().unwrap();
    (solution, stages.iter().find(|stage| stage["name"] == "solve").unwrap().clone())
}

fn assert_field(fields: &[octruss_meshio::Field], name: &str, exact: &[f64]) {
    let field = fields.iter().find(|field| field.name == name).unwrap();
    assert_eq!(field.components, exact.len(), "{name}");
    let Values::Float(values) = &field.values else { panic!("{name} holds whole numbers") };
    for tuple in values.chunks(exact.len()) {
        for (found, exact) in tuple.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-6, "{name}: {tuple:?}");
        }
    }
}

#[test]
fn a_pulled_cube_has_the_textbook_strain_in_the_file_and_the_force_in_the_report() {
    let (solution, solve) = run(GOOD);
    // σ = 4, E = 200, ν = 0.3: strains 0.02 and −0.006.
    for fields in [&solution.point_fields, &solution.cell_fields] {
        assert_field(fields, "stress", &[4.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_field(fields, "strain", &[0.02, -0.006, -0.006, 0.0, 0.0, 0.0]);
        assert_field(fields, "von-mises", &[4.0]);
    }
    let displacement = &solution.point_fields[0];
    assert_eq!((displacement.name.as_str(), displacement.components), ("displacement", 3));
    let Values::Float(values) = &displacement.values else { panic!() };
    for ([x, y, z], u) in solution.mesh.points.iter().zip(values.as_chunks::<3>().0) {
        let exact = [0.02 * x, -0.006 * y, -0.006 * z];
        assert!((0..3).all(|k| (u[k] - exact[k]).abs() < 1e-8), "{u:?} for {exact:?}");
    }
    let near =
        |value: &serde_json::Value, exact: f64| (value.as_f64().unwrap() - exact).abs() < 1e-6;
    let forces = &solve["forces"];
    assert_eq!(forces["reactions"][0]["name"], "x0");
    assert!(near(&forces["reactions"][0]["x"], -4.0) && near(&forces["loads"]["x"], 4.0));
    assert!(forces["imbalance"].as_f64().unwrap() < 1e-7);
    assert!(near(&solve["greatest_von_mises"], 4.0));
}

#[test]
fn supports_moved_far_away_stress_a_body_as_those_that_are_not() {
    // Two ends bent by 1e-6 y, at 0 and at 1000: of sixteen digits seven are left.
    let bent = |offset: &str| {
        let loads = "traction = [{ surface = \"x1\", value = [4, 0, 0] }]";
        let held = "fixed = [{ surface = \"x0\", normal = 0 }, { surface = \"y0\", y = 0 }, \
            { surface = \"z0\", z = 0 }]";
        let end =
            |side: &str| format!("{{ surface = \"{side}\", value = [\"{offset}1e-6*y\", 0, 0] }}");
        let fixed = format!("fixed = [{}, {}]", end("x0"), end("x1"));
        run(&GOOD.replace(loads, "").replace(held, &fixed)).1
    };
    let [near, far] = ["", "1e3 + "].map(bent);
    let greatest = |solve: &serde_json::Value| solve["greatest_von_mises"].as_f64().unwrap();
    assert!((greatest(&far) / greatest(&near) - 1.0).abs() < 1e-5, "{near} {far}");
    assert!(far["forces"]["imbalance"].as_f64().unwrap() < 1e-6, "{far}");
    assert!(far["notes"].is_null(), "{far}");
    assert!(far["solves"][0]["maximum"].as_f64().unwrap() > 999.0);
}

#[test]
fn forces_that_do_not_balance_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let loose = GOOD.replace("material =", "tolerance = 0.2\nmaterial =");
    write_config(folder.path(), &loose);
    let output = octruss(folder.path(), &["run", "c.toml", "--out", "out", "--quiet"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let told = stderr(&output);
    assert!(told.contains("note: the forces on the body balance to"), "{told}");
    let report = report(&folder.path().join("out"));
    let stages = report["stages"].as_array().unwrap();
    let solve = stages.iter().find(|stage| stage["name"] == "solve").unwrap();
    assert!(solve["notes"][0].as_str().unwrap().starts_with("the forces on the body"));
}

#[test]
fn a_body_that_nothing_holds_floats_if_asked_to() {
    // Pulled at both ends, and at one: then by its own inertia, with a note.
    let held = "fixed = [{ surface = \"x0\", normal = 0 }, { surface = \"y0\", y = 0 }, \
        { surface = \"z0\", z = 0 }]";
    let pulled = "traction = [{ surface = \"x0\", value = [-4, 0, 0] }, ";
    let free = GOOD.replace(held, "free = \"balance\"");
    let (solution, solve) = run(&free.replace("traction = [", pulled));
    assert_field(&solution.cell_fields, "stress", &[4.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert!(solve["notes"].is_null(), "{solve}");
    assert!(solve["free_parts"][0]["share"].as_f64().unwrap() < 1e-12);
    let (_, solve) = run(&free);
    assert!((solve["free_parts"][0]["acceleration"]["x"].as_f64().unwrap() - 4.0).abs() < 1e-9);
    assert!((solve["forces"]["inertia"]["x"].as_f64().unwrap() + 4.0).abs() < 1e-9);
    assert!(solve["forces"]["imbalance"].as_f64().unwrap() < 1e-9);
    assert!(solve["notes"][0].as_str().unwrap().contains("its loads do not balance"));
}

#[test]
fn expressions_stand_wherever_numbers_do() {
    // The same state by other words: E doubled and halved again, the traction and
    // the planes by expressions that come to the same.
    let said_otherwise = GOOD
        .replace("young = 200", "young = \"if(x < 2, 2*10^2, 1)\"")
        .replace("normal = 0", "normal = \"0*x\"")
        .replace("[4, 0, 0]", "[\"4 + 0*sin(pi*y)\", 0, \"min(z, 0)\"]");
    let (solution, _) = run(&said_otherwise);
    assert_field(&solution.cell_fields, "stress", &[4.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn a_prescribed_stretch_is_carried_by_the_supports() {
    // u_x = 0.02 on x = 1 in place of the traction: the same state, and a
    // reaction of 4 there.
    let stretched = GOOD
        .replace("traction = [{ surface = \"x1\", value = [4, 0, 0] }]", "")
        .replace("fixed = [", "fixed = [{ surface = \"x1\", x = \"0.02*x\" }, ");
    let (solution, solve) = run(&stretched);
    assert_field(&solution.cell_fields, "stress", &[4.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let reactions = &solve["forces"]["reactions"];
    assert!((reactions[0]["x"].as_f64().unwrap() - 4.0).abs() < 1e-6, "{reactions}");
    assert!((reactions[1]["x"].as_f64().unwrap() + 4.0).abs() < 1e-6, "{reactions}");
}

#[test]
fn wrong_elastic_configs_are_told_with_file_line_and_key() {
    for (from, to, says) in [
        (
            "traction",
            "flux",
            "c.toml:16:1: stage `solve`: `flux` belongs to problem = \"poisson\", but this stage \
             solves \"elasticity\" (keys of its own: material, body-force, gravity, traction, \
             pressure, springs, free)",
        ),
        ("[4, 0, 0]", "4", "c.toml:16:39: `value` in stage `solve`: found integer `4`, expected "),
        (
            "[4, 0, 0]",
            "[4, 0, 0, 0]",
            "c.toml:16:39: `value` in stage `solve`: expected a list of three, x, y and z, found 4",
        ),
        (
            "normal = 0",
            "value = [0, 0]",
            "c.toml:15:36: `value` in stage `solve`: expected a list of three, x, y and z, found 2",
        ),
        (
            "normal = 0",
            "normal = 0, x = 0",
            "c.toml:15:10: stage `solve`: an entry of `fixed` gives the displacement in one of \
             three ways: value = [0, 0, 0], some of x, y and z, or normal = 0",
        ),
        (
            "normal = 0",
            "value = 0",
            "c.toml:15:10: stage `solve`: `value` of a displacement is a list of three",
        ),
        (
            "material = { young = 200, poisson = 0.3 }",
            "",
            "c.toml:11:1: stage `solve`: problem = \"elasticity\" needs `material`, such as",
        ),
        (
            "young = 200",
            "yuong = 200",
            "c.toml:14:12: `material` in stage `solve`: unknown key `yuong`; did you mean `young`? \
             (valid: young, poisson, density)",
        ),
        (
            "young = 200, ",
            "",
            "c.toml:14:12: `material` in stage `solve`: a material needs `young`, Young's modulus",
        ),
        (
            "{ young = 200, poisson = 0.3 }",
            "{ cube = { young = 200 } }",
            "c.toml:14:21: missing key `poisson` in stage `solve`",
        ),
        (
            "{ young = 200, poisson = 0.3 }",
            "{ cubes = { young = 200, poisson = 0.3 } }",
            "c.toml:14:14: stage `solve`: no region is called `cubes`; did you mean `cube`?",
        ),
        (
            "poisson = 0.3",
            "poisson = 0.5",
            "stage `solve`, assembly: the Poisson's ratio of region 1 is 0.5 (tet 0); it must be \
             above -1 and below 0.5",
        ),
        (
            "{ surface = \"y0\", y = 0 }, ",
            "",
            "stage `solve`, assembly: a connected part of the mesh with 773 vertices, among them \
             vertex 0, can still move as a rigid body: translation along y; hold more of it",
        ),
        (
            "{ young = 200, poisson = 0.3 }",
            "{ young = 200, poisson = \"0.3*t\" }",
            "c.toml:14:37: `poisson` in stage `solve`: expression \"0.3*t\", column 5: unknown \
             name `t` (valid: x, y, z, pi, e)",
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(GOOD.matches(from).count(), 1, "`{from}` is once in the good config");
        write_config(folder.path(), &GOOD.replace(from, to));
        let output = octruss(folder.path(), &["run", "c.toml", "--quiet"]);
        let message = stderr(&output);
        assert!(message.starts_with(&format!("error: {says}")), "`{to}` → {message}");
        assert!(!message.contains("panicked") && message.lines().count() == 1, "{message}");
        let expected =
            if message.contains("assembly") || message.contains("no region") { 1 } else { 2 };
        assert_eq!(code(&output), expected, "{message}");
    }
}
