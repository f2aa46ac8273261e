//! What configs with known results say of single places and of two levels together, which no
//! number of one report tells. Sources stand in the configs.

mod common;

use common::{report, repository, succeed};
use octruss_meshio::{Dataset, Values, read};

/// Runs a config with so many levels; the finest mesh with its fields, and the greatest value
/// of the solution.
fn run(name: &str, levels: usize) -> (Dataset, f64) {
    let folder = tempfile::tempdir().unwrap();
    let config = repository(&format!("configs/{name}.toml")).display().to_string();
    let levels = format!("stage.subdivide.levels={levels}");
    let arguments =
        ["run", &config, "--out", "known", "--set", &levels, "--set", "expect={}", "--quiet"];
    succeed(folder.path(), &arguments);
    let out = folder.path().join("known");
    let report = report(&out);
    let stages = report["stages"].as_array().unwrap();
    let solve = stages.iter().find(|stage| stage["name"] == "solve").unwrap();
    let maximum = solve["solves"][0]["maximum"].as_f64().unwrap();
    (read(&out.join("solution.vtu")).unwrap(), maximum)
}

/// A field at the vertices, by its name.
fn values<'a>(solution: &'a Dataset, name: &str) -> &'a [f64] {
    let field = solution.point_fields.iter().find(|field| field.name == name).unwrap();
    let Values::Float(values) = &field.values else { panic!("{name} holds whole numbers") };
    values
}

#[test]
fn nafems_t4_has_its_target_at_e() {
    let (solution, _) = run("nafems-t4", 3);
    let at_e = |p: &[f64; 3]| (p[0] - 0.6).abs() < 1e-9 && (p[1] - 0.2).abs() < 1e-9;
    let points = solution.mesh.points.iter().zip(values(&solution, "solution"));
    let found: Vec<f64> = points.filter(|(p, _)| at_e(p)).map(|(_, &value)| value).collect();
    // Through the thickness of one tet, halved three times.
    assert_eq!(found.len(), 9);
    // The series; published as 18.3.
    let (exact, mean) = (18.2538_f64, found.iter().sum::<f64>() / 9.0);
    assert!((mean - exact).abs() < 0.001 * exact, "{mean}");
    assert!(found.iter().all(|value| (value - exact).abs() < 0.002 * exact), "{found:?}");
}

#[test]
fn the_bore_of_a_thick_pipe_has_lames_hoop_stress() {
    let (solution, _) = run("lame-pipe", 1);
    let stresses = values(&solution, "stress").as_chunks::<6>().0;
    let mut hoops = Vec::new();
    for (&[x, y, _], &[xx, yy, _, xy, ..]) in solution.mesh.points.iter().zip(stresses) {
        if (x.hypot(y) - 1.0).abs() < 5e-4 {
            hoops.push((xx * y * y + yy * x * x - 2.0 * xy * x * y) / (x * x + y * y));
        }
    }
    // 32 segments, halved, and one layer, halved.
    assert_eq!(hoops.len(), 65 * 3);
    let (exact, mean) = (5.0 / 3.0, hoops.iter().sum::<f64>() / hoops.len() as f64);
    assert!((mean - exact).abs() < 0.01 * exact, "{mean}");
    assert!(hoops.iter().all(|hoop| (hoop - exact).abs() < 0.03 * exact), "{hoops:?}");
}

#[test]
fn two_levels_of_a_cantilever_extrapolate_to_timoshenkos_beam() {
    let [coarse, fine] = [1, 2].map(|levels| run("timoshenko-cantilever", levels).1);
    let (exact, extrapolated) = (4.0352, (4.0 * fine - coarse) / 3.0);
    assert!(coarse < fine && fine < exact, "too stiff, and by less: {coarse} {fine}");
    assert!((extrapolated - exact).abs() < 0.005 * exact, "{extrapolated}");
    assert!((fine - exact).abs() > 0.02 * exact, "two levels alone are not enough: {fine}");
}
