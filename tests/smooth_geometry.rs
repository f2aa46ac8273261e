//! Refining round bodies from the command line: mirror planes, limits, what is remarked.

mod common;

use common::{code, octruss, sample, stderr, succeed};
use octruss_meshio::read;
use std::path::Path;

fn mesh(name: &str) -> String {
    sample(&format!("{name}.msh")).display().to_string()
}

/// Refines once by box splines; what is said.
fn refine(folder: &Path, mesh: &str, more: &[&str]) -> (i32, String) {
    let arguments = ["refine", mesh, "out.vtu", "--scheme", "box-spline", "--levels", "1"];
    let output = octruss(folder, &[&arguments[..], more].concat());
    (code(&output), stderr(&output))
}

/// The bytes of the file that refining by box splines, some levels, writes.
fn refined_file(folder: &Path, [from, to, levels]: [&str; 3], more: &[&str]) -> Vec<u8> {
    let arguments = ["refine", from, to, "--scheme", "box-spline", "--levels", levels];
    succeed(folder, &[&arguments[..], more].concat());
    std::fs::read(folder.join(to)).unwrap()
}

/// How far the wall of the hole of the quarter plate, radius 2, is from round.
fn roundness(folder: &Path) -> f64 {
    let surfaces = read(&folder.join("out.vtu")).unwrap().mesh;
    let hole = surfaces.group_ids(2, "hole")[0];
    assert!(surfaces.triangles.iter().any(|(_, tag)| tag == hole));
    let wall = surfaces.triangles.iter().filter(|(_, tag)| *tag == hole);
    let radius = |v: u32| {
        let [x, y, _] = surfaces.points[v as usize];
        x.hypot(y)
    };
    wall.flat_map(|(triangle, _)| triangle)
        .map(|v| (radius(v) / 2.0 - 1.0).abs())
        .fold(0.0, f64::max)
}

#[test]
fn a_hole_is_round_up_to_planes_that_are_named_as_mirrors() {
    let folder = tempfile::tempdir().unwrap();
    let plate = mesh("quarter-plate");
    let mirrors = ["--mirror", "xsym", "--mirror", "ysym"];
    assert_eq!(refine(folder.path(), &plate, &mirrors).0, 0);
    let mirrored = roundness(folder.path());
    let fixed_ends = ["--curve-ends", "fixed"];
    assert_eq!(refine(folder.path(), &plate, &fixed_ends).0, 0);
    let cut = roundness(folder.path());
    assert!(mirrored < 1e-4 && mirrored < 0.1 * cut, "{mirrored:e} {cut:e}");
}

#[test]
fn a_second_run_goes_on_with_mirrors_and_surface_of_the_first() {
    let folder = tempfile::tempdir().unwrap();
    let refine = |from: &str, to: &str, levels: &str, more: &[&str]| {
        refined_file(folder.path(), [from, to, levels], more)
    };
    let (plate, mirrors) = (mesh("quarter-plate"), ["--mirror", "xsym", "--mirror", "ysym"]);
    refine(&plate, "once.vtu", "1", &mirrors);
    let twice = refine("once.vtu", "twice.vtu", "1", &[]);
    assert!(twice == refine(&plate, "both.vtu", "2", &mirrors));
}

#[test]
fn projecting_goes_with_mirrors() {
    let folder = tempfile::tempdir().unwrap();
    let plate = mesh("quarter-plate");
    for more in [&["--interpolate=false"][..], &[]] {
        let arguments = ["--project-limit", "--mirror", "xsym", "--mirror", "ysym"];
        let (code, message) = refine(folder.path(), &plate, &[&arguments[..], more].concat());
        assert_eq!(code, 0, "{message}");
    }
    // Through the input, with all vertices of the hole on the limit.
    assert!(roundness(folder.path()) < 1e-4);
}

#[test]
fn a_linear_level_before_takes_nothing_from_a_smooth_one() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["--scheme", "linear", "--levels", "1"];
    let ball = mesh("ball");
    succeed(folder.path(), &[&["refine", &ball, "linear.vtu"][..], &arguments].concat());
    let (_, told) = refine(folder.path(), "linear.vtu", &[]);
    assert!(!told.contains("note:"), "{told}");
    let [before, after] =
        ["linear.vtu", "out.vtu"].map(|name| read(&folder.path().join(name)).unwrap().mesh.points);
    assert!(before.iter().all(|point| after.contains(point)));
}

#[test]
fn what_cannot_be_a_mirror_is_told_with_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let plate = mesh("quarter-plate");
    for (name, says) in [
        ("hole", "surface hole cannot be a mirror plane: it is up to"),
        ("xsim", "stage `subdivide`: no surface is called `xsim`; did you mean `xsym`?"),
    ] {
        let (code, message) = refine(folder.path(), &plate, &["--quiet", "--mirror", name]);
        assert!(code != 0 && message.contains(says), "{message}");
        assert_eq!(message.matches("stage `subdivide`").count(), 1, "{message}");
        assert!(!folder.path().join("out.vtu").exists());
    }
}

#[test]
fn a_body_that_loses_volume_is_remarked_and_one_that_keeps_it_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let ball = mesh("ball");
    let volume = || {
        let told = succeed(folder.path(), &["info", "out.vtu", "--json"]);
        let told: serde_json::Value = serde_json::from_str(&told).unwrap();
        told["volume"].as_f64().unwrap()
    };
    let (_, plain) = refine(folder.path(), &ball, &["--interpolate=false"]);
    assert!(plain.contains("the volume changed by -5.3 %"), "{plain}");
    let shrunk = volume();
    let (_, through) = refine(folder.path(), &ball, &[]);
    assert!(!through.contains("note:"), "{through}");
    let kept = volume();
    refine(folder.path(), &ball, &["--project-limit"]);
    let exact = 4.0 / 3.0 * std::f64::consts::PI;
    assert!(shrunk < 0.89 * exact && kept > 0.97 * exact && volume() > 0.97 * exact);
}

#[test]
fn keys_that_a_scheme_has_no_use_for_are_remarked() {
    let folder = tempfile::tempdir().unwrap();
    let ball = mesh("ball");
    let arguments = "refine BALL out.vtu --scheme linear --levels 1 --interpolate --project-limit \
                     --curve-ends fixed";
    let arguments: Vec<&str> =
        arguments.split(' ').map(|word| if word == "BALL" { &ball } else { word }).collect();
    let output = octruss(folder.path(), &arguments);
    for key in ["interpolate", "project-limit", "curve-ends"] {
        let says = format!("the linear scheme keeps vertices: {key} without effect");
        assert!(stderr(&output).contains(&says), "{}", stderr(&output));
    }
}

#[test]
fn what_was_refined_as_published_goes_on_so() {
    let folder = tempfile::tempdir().unwrap();
    let refine = |from: &str, to: &str, levels: &str, more: &[&str]| {
        refined_file(folder.path(), [from, to, levels], more)
    };
    let bracket = mesh("bracket");
    for diagonal in ["inherit", "shortest-each-level"] {
        let published = ["--interpolate=false", "--diagonal", diagonal];
        refine(&bracket, "once.vtu", "1", &published);
        let twice = refine("once.vtu", "twice.vtu", "1", &published[1..]);
        assert!(twice == refine(&bracket, "both.vtu", "2", &published), "{diagonal}");
    }
}
