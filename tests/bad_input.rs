//! Wrong configs, wrong meshes, wrong places: one clear message each, the right
//! exit code, nothing half-written.

mod common;

use std::path::Path;

use common::{code, files, octruss, repository, sample, stderr, succeed};

/// A config that runs, for one line to be spoilt. Line numbers count.
const GOOD: &str = r#"name = "good"
[[stage]]
kind = "import"
path = "MESH"
[[stage]]
kind = "check"
[[stage]]
kind = "subdivide"
levels = 1
scheme = "linear"
crease-angle = 40
[[stage]]
kind = "solve"
coefficient = { default = 1, cube = 2 }
fixed = [{ surface = "x0", value = 0 }]
flux = [{ surface = "x1", value = 1 }]
prolongation = ["linear"]
tolerance = 1e-8
[expect]
"subdivide.tets" = { min = 2880, max = 2880 }
"#;

struct Spoilt {
    /// What is replaced in the good config, and by what.
    change: [&'static str; 2],
    /// The place and the start of the message.
    says: &'static str,
    code: i32,
}

const fn spoilt(change: [&'static str; 2], says: &'static str, code: i32) -> Spoilt {
    Spoilt { change, says, code }
}

const TABLE: [Spoilt; 39] = [
    spoilt(
        ["levels", "levles"],
        "9:1: unknown key `levles` in stage `subdivide`; did you mean `levels`? (valid: ",
        2,
    ),
    spoilt(
        ["levels = 1", "levels = -1"],
        "9:10: `levels` in stage `subdivide`: found integer `-1`, expected a whole number from 0 to 255",
        2,
    ),
    spoilt(
        ["levels = 1", "levels = \"one\""],
        "9:10: `levels` in stage `subdivide`: found string \"one\", expected a whole number",
        2,
    ),
    spoilt(
        ["levels = 1", "levels = 1.5"],
        "9:10: `levels` in stage `subdivide`: found number `1.5`, expected a whole number",
        2,
    ),
    spoilt(["levels = 1", "levels = 1\nlevels = 2"], "10:1: duplicate key", 2),
    spoilt(["levels = 1", "levels = "], "9:10: ", 2),
    spoilt(
        ["\"linear\"\ncrease", "\"lineer\"\ncrease"],
        "10:10: `scheme` in stage `subdivide`: unknown scheme `lineer`; did you mean `linear`? (valid: linear, box-spline, ",
        2,
    ),
    spoilt(
        ["crease-angle = 40", "crease-angle = 200"],
        "11:16: `crease-angle` in stage `subdivide`: expected an angle from 0 to 180 degrees, found 200",
        2,
    ),
    spoilt(
        ["crease-angle = 40", "group-borders = \"flatt\""],
        "11:17: `group-borders` in stage `subdivide`: unknown choice of group borders `flatt`; did you mean `flat`? (valid: flat, all, none)",
        2,
    ),
    spoilt(
        ["crease-angle = 40", "group-borders = 1"],
        "11:17: `group-borders` in stage `subdivide`: found integer `1`, expected \"flat\", \"all\" or true, \"none\" or false",
        2,
    ),
    spoilt(["path = \"MESH\"", ""], "2:1: missing key `path` in stage `import`", 2),
    spoilt(
        ["kind = \"check\"", "kind = \"chekc\""],
        "6:8: unknown kind of stage `chekc`; did you mean `check`? (valid: import, check, subdivide, solve, write)",
        2,
    ),
    spoilt(["kind = \"check\"", "kind = 3"], "6:8: `kind` must be a string", 2),
    spoilt(["kind = \"check\"", ""], "5:1: a stage needs a `kind` (valid: import, ", 2),
    spoilt(
        ["[[stage]]\nkind = \"check\"\n", ""],
        "5:1: stage `subdivide` needs a stage `check` before it",
        2,
    ),
    spoilt(
        ["name = \"good\"", "nmae = \"good\""],
        "1:1: unknown key `nmae`; did you mean `name`? (valid: name, stage, compare, expect)",
        2,
    ),
    spoilt(["name = \"good\"", ""], "1:1: missing key `name`", 2),
    spoilt(
        ["name = \"good\"", "name = \"../good\""],
        "1:8: `name` is \"../good\", but it must do as the name of a folder",
        2,
    ),
    spoilt(["[expect]", "[expects]"], "19:2: unknown key `expects`; did you mean `expect`?", 2),
    spoilt(
        ["{ min = 2880, max = 2880 }", "{ mim = 2880 }"],
        "20:22: unknown key `mim`; did you mean `min`? (valid: min, max)",
        2,
    ),
    spoilt(
        ["{ min = 2880, max = 2880 }", "{ min = 9, max = 8 }"],
        "20:20: `subdivide.tets`: no number is at least 9 and at most 8",
        2,
    ),
    spoilt(
        ["{ min = 2880, max = 2880 }", "{}"],
        "20:20: `subdivide.tets`: an expectation needs `min`, `max` or both",
        2,
    ),
    spoilt(
        ["\"subdivide.tets\"", "\"subdivide.tetz\""],
        "20:1: the report has no number `subdivide.tetz`; did you mean `subdivide.tets`?",
        2,
    ),
    spoilt(
        ["value = 0", "value = \"sinn(x)\""],
        "15:36: `value` in stage `solve`: expression \"sinn(x)\", column 1: unknown function `sinn`; did you mean `sin`? (valid: sin, cos, ",
        2,
    ),
    spoilt(
        ["value = 0", "value = \"1/0\""],
        "15:36: `value` in stage `solve`: expected a finite number, but \"1/0\" is inf",
        2,
    ),
    spoilt(
        ["value = 1 }]", "value = \"1/(x - x)\" }]"],
        "stage `solve`, assembly: the flux of surface 2 is `1/(x - x)` = inf at (1, ",
        1,
    ),
    spoilt(
        ["value = 0", "value = [0, 0, 0]"],
        "15:10: stage `solve`: an entry of `fixed` gives one `value`: x, y, z, normal and lists",
        2,
    ),
    spoilt(
        ["tolerance = 1e-8", "gravity = [0, 0, -9.81]"],
        "18:1: stage `solve`: `gravity` belongs to problem = \"elasticity\", but this stage solves \"poisson\" (keys of its own: coefficient, source, flux, robin, free)",
        2,
    ),
    spoilt(["flux =", "robin ="], "16:10: missing key `coefficient` in stage `solve`", 2),
    spoilt(
        ["default = 1", "default = inf"],
        "14:27: `default` in stage `solve`: expected a finite number, found inf",
        2,
    ),
    spoilt(
        ["tolerance = 1e-8", "tolerance = -1e-8"],
        "18:13: `tolerance` in stage `solve`: expected a number above 0, found -0.00000001",
        2,
    ),
    spoilt(
        ["tolerance = 1e-8", "tolerance = 1e-8\nproblem = \"poison\""],
        "19:11: unknown value `poison` in stage `solve`; did you mean `poisson`? (valid: poisson, biharmonic, elasticity)",
        2,
    ),
    spoilt(
        ["\"x0\"", "\"bolt\""],
        "15:22: stage `solve`: no surface is called `bolt` (valid: x0, x1, y0, y1, z0, z1)",
        1,
    ),
    spoilt(
        ["cube = 2", "cubes = 2"],
        "14:30: stage `solve`: no region is called `cubes`; did you mean `cube`? (valid: cube)",
        1,
    ),
    spoilt(
        ["[\"linear\"]", "[\"linear\", \"linear\"]"],
        "17:16: `prolongation` in stage `solve`: entry 2 of the list stands in it before",
        2,
    ),
    spoilt(
        ["[\"linear\"]", "[\"smoothed-lineer\"]"],
        "17:17: unknown prolongation `smoothed-lineer`; did you mean `smoothed-linear`?",
        2,
    ),
    spoilt(
        ["[\"linear\"]", "[{ finest = \"linear\" }]"],
        "17:17: missing key `coarser` in stage `solve`",
        2,
    ),
    spoilt(
        ["fixed = [{ surface = \"x0\", value = 0 }]", ""],
        "stage `solve`, assembly: nothing is fixed",
        1,
    ),
    spoilt(
        ["value = 1 }]", "value = 0 }]"],
        "stage `solve`, assembly: nothing acts on what is free, so the solution would be zero \
         everywhere: source, flux, Robin and prescribed values are all 0",
        1,
    ),
];

fn write_config(folder: &Path, text: &str) {
    let mesh = sample("cube.msh").display().to_string();
    std::fs::write(folder.join("c.toml"), text.replace("MESH", &mesh)).unwrap();
}

#[test]
fn the_config_that_the_table_spoils_is_good() {
    let folder = tempfile::tempdir().unwrap();
    write_config(folder.path(), GOOD);
    succeed(folder.path(), &["run", "c.toml"]);
}

#[test]
fn wrong_configs_are_told_with_file_line_and_key() {
    for Spoilt { change: [from, to], says, code: expected } in TABLE {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(GOOD.matches(from).count(), 1, "`{from}` is once in the good config");
        write_config(folder.path(), &GOOD.replace(from, to));
        let output = octruss(folder.path(), &["run", "c.toml", "--quiet"]);
        let message = stderr(&output);
        let start = if says.starts_with("stage") { "error: " } else { "error: c.toml:" };
        assert!(message.starts_with(&format!("{start}{says}")), "`{to}` → {message}");
        assert!(!message.contains("panicked") && message.lines().count() == 1, "{message}");
        assert_eq!(code(&output), expected, "{message}");
        // An unknown expectation shows only after the run, which then is kept.
        let kept = says.contains("the report has no number");
        assert_eq!(folder.path().join("out").exists(), kept, "`{to}`");
    }
}

#[test]
fn wrong_overrides_are_told_as_typed() {
    let config = repository("configs/cube-poisson.toml").display().to_string();
    for (set, says) in [
        ("levels", "expected KEY=VALUE"),
        ("a b=1", "`a b` is not a key"),
        ("nam=x", "unknown key `nam`; did you mean `name`?"),
        ("stage=[]", "the config has no stage"),
        (
            "stage.subdivide.levles=1",
            "unknown key `levles` in stage `subdivide`; did you mean `levels`?",
        ),
        (
            "stage.subdvide.levels=1",
            "unknown stage `subdvide`; did you mean `subdivide`? (valid: import,",
        ),
        ("stage.solve-2.sweeps=1", "unknown stage `solve-2`; did you mean `solve`?"),
        ("stage.subdivide.levels=-1", "`levels` in stage `subdivide`: found integer `-1`"),
        (
            "stage.solve.sweeps=0",
            "`sweeps` in stage `solve`: found integer `0`, expected a whole number from 1",
        ),
        (
            "stage.solve.fixed.6.value=1",
            "`stage.solve.fixed` has 6 entries, counted from 0, none is `6`",
        ),
        (
            "stage.solve.fixed.0.valeu=1",
            "unknown key `valeu` in stage `solve`; did you mean `value`?",
        ),
        ("stage.solve.source.cube=1", "`stage.solve.source` is one float, no table with keys"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let output = octruss(folder.path(), &["run", &config, "--set", set]);
        let message = stderr(&output);
        assert!(message.starts_with(&format!("error: --set {set}: {says}")), "{message}");
        assert_eq!(code(&output), 2, "{message}");
        assert!(files(folder.path()).is_empty());
    }
}

/// Files that are no mesh, or not the one their name says.
fn write_bad_meshes(folder: &Path) {
    let gmsh = std::fs::read(sample("cube.msh")).unwrap();
    let surface_only = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n\
        3 0 1 0\n$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n";
    for (name, content) in [
        ("empty.msh", &b""[..]),
        ("empty.vtu", b""),
        ("garbage.msh", b"\xff\xfe\x00\x01"),
        ("garbage.vtk", b"\xff\xfe\x00\x01"),
        ("mislabelled.vtu", &gmsh),
        ("mislabelled.vtk", &gmsh),
        ("truncated.msh", &gmsh[..gmsh.len() / 2]),
        ("unknown.stl", b"solid"),
        ("flat.msh", surface_only.as_bytes()),
    ] {
        std::fs::write(folder.join(name), content).unwrap();
    }
}

#[test]
fn bad_meshes_stop_every_command_with_the_file_named() {
    let folder = tempfile::tempdir().unwrap();
    write_bad_meshes(folder.path());
    let before = files(folder.path());
    let refine = ["--scheme", "linear", "--levels", "1"];
    for (name, says) in [
        ("missing.msh", "No such file"),
        ("empty.msh", "empty"),
        ("empty.vtu", "empty"),
        ("garbage.msh", "not a Gmsh mesh"),
        ("garbage.vtk", "cannot be understood"),
        ("mislabelled.vtu", ".msh"),
        ("mislabelled.vtk", ".msh"),
        ("truncated.msh", "it is cut off, write it again"),
        ("unknown.stl", ".stl"),
    ] {
        for arguments in [
            vec!["info", name],
            vec!["convert", name, "out.vtu"],
            [vec!["refine", name, "out.vtu", "--quiet"], refine.to_vec()].concat(),
        ] {
            let output = octruss(folder.path(), &arguments);
            let message = stderr(&output);
            assert_eq!(code(&output), 1, "{arguments:?}: {message}");
            assert!(message.starts_with(&format!("error: {name}")), "{arguments:?}: {message}");
            assert!(message.contains(says) && !message.contains("panicked"), "{message}");
            assert_eq!(files(folder.path()), before, "{arguments:?}");
        }
    }
}

#[test]
fn a_mesh_without_tets_is_described_but_not_refined() {
    let folder = tempfile::tempdir().unwrap();
    write_bad_meshes(folder.path());
    let text = succeed(folder.path(), &["info", "flat.msh", "--json"]);
    let info: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((info["tets"].as_u64(), info["vertices"].as_u64()), (Some(0), Some(3)));
    assert_eq!(info["findings"][0]["kind"], "no-tets");
    assert!(info["quality"].is_null());
    let arguments = ["refine", "flat.msh", "out.vtu", "--scheme", "linear", "--levels", "1"];
    let output = octruss(folder.path(), &arguments);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("no tets"), "{}", stderr(&output));
    assert!(!folder.path().join("out.vtu").exists());
}

/// One tet, once inverted and once with a vertex that does not exist.
fn one_tet(tet: &str) -> String {
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n\
         $EndNodes\n$Elements\n1\n1 4 2 1 1 {tet}\n$EndElements\n"
    )
}

#[test]
fn inverted_tets_are_found_and_turned_over_if_asked() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("inverted.msh"), one_tet("2 1 3 4")).unwrap();
    let text = succeed(folder.path(), &["info", "inverted.msh", "--json"]);
    let info: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(info["findings"][0]["kind"], "inverted-tets");
    assert_eq!(info["findings"][0]["count"], 1);
    assert_eq!(info["findings"][0]["examples"], serde_json::json!([0]));
    let arguments = ["refine", "inverted.msh", "out.vtu", "--scheme", "linear", "--levels", "1"];
    let output = octruss(folder.path(), &arguments);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("1 inverted tets (tet 0)"), "{}", stderr(&output));
    assert!(!folder.path().join("out.vtu").exists());
    succeed(folder.path(), &[&arguments[..], &["--reorient"]].concat());
    let text = succeed(folder.path(), &["info", "out.vtu", "--json"]);
    let info: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(info["findings"], serde_json::json!([]));
    assert!((info["volume"].as_f64().unwrap() - 1.0 / 6.0).abs() < 1e-15);
}

#[test]
fn output_that_cannot_be_written_is_told_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "mine").unwrap();
    let config = repository("configs/cube-poisson.toml").display().to_string();
    for out in ["file", "file/below"] {
        let output = octruss(folder.path(), &["run", &config, "--out", out]);
        assert_eq!(code(&output), 1);
        let message = stderr(&output);
        assert_eq!(message, "error: cannot write to file: it is a file, not a folder\n");
    }
    assert_eq!(std::fs::read(folder.path().join("file")).unwrap(), b"mine");
    let mesh = sample("cube.msh").display().to_string();
    for (out, says) in [
        ("none/out.vtu", "the folder does not exist"),
        ("file/out.vtu", "not a folder"),
        ("out.stl", ".stl"),
        ("out.msh", "not written"),
    ] {
        let output = octruss(folder.path(), &["convert", &mesh, out]);
        assert_eq!(code(&output), 1);
        assert!(stderr(&output).contains(says), "{}", stderr(&output));
    }
    assert_eq!(files(folder.path()).len(), 1);
}

#[test]
fn refining_refuses_before_the_work_what_cannot_be_finished() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = sample("cube.msh").display().to_string();
    for (out, levels, says) in [
        ("none/out.vtu", "1", "error: none: the folder does not exist"),
        ("out.msh", "1", "error: out.msh: Gmsh files are read, not written"),
        // 360 · 8^7 = 754,974,720 tets, with 6 edges each, exceed 2^32 − 1; 8^6 do not.
        ("out.vtu", "7", "360 · 8^7 tets, more than the 715827882 that can be numbered; at most 6"),
    ] {
        let arguments = ["refine", &mesh, out, "--scheme", "linear", "--levels", levels];
        let output = octruss(folder.path(), &arguments);
        let message = stderr(&output);
        assert!(code(&output) == 1 && message.contains(says), "{message}");
        assert!(!message.contains("level 1 of"), "{message}");
        assert!(files(folder.path()).is_empty());
    }
}

#[test]
fn a_failed_run_leaves_no_report_of_an_earlier_one() {
    let folder = tempfile::tempdir().unwrap();
    write_config(folder.path(), GOOD);
    let report = folder.path().join("out/good/report.json");
    succeed(folder.path(), &["run", "c.toml"]);
    assert!(report.exists());
    let spoilt = ["run", "c.toml", "--quiet", "--set", "stage.solve.source={ nowhere = 1 }"];
    let output = octruss(folder.path(), &spoilt);
    let message = stderr(&output);
    assert_eq!(code(&output), 1, "{message}");
    assert!(message.contains("nowhere"), "{message}");
    assert!(!report.exists());
}

#[test]
fn a_region_called_default_is_not_taken_for_all_others() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = std::fs::read_to_string(sample("cube.msh")).unwrap();
    assert!(mesh.contains("\"cube\""));
    std::fs::write(folder.path().join("d.msh"), mesh.replace("\"cube\"", "\"default\"")).unwrap();
    let config = GOOD.replace("MESH", "d.msh").replace(", cube = 2", "");
    std::fs::write(folder.path().join("c.toml"), config).unwrap();
    let output = octruss(folder.path(), &["run", "c.toml", "--quiet"]);
    let message = stderr(&output);
    assert_eq!(code(&output), 1, "{message}");
    let says = "error: c.toml:14:17: stage `solve`: `default` stands for all regions";
    assert!(message.starts_with(says), "{message}");
}

/// Two tets that share a face, of which the published box splines invert a part at level 2
/// where nothing is kept sharp; found by trying random corners.
const FOLDING: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 4 0 0\n\
    3 0 4 0\n4 0 0 4\n5 -2 -6 -4\n$EndNodes\n$Elements\n2\n1 4 2 1 1 1 2 3 4\n\
    2 4 2 1 1 3 1 4 5\n$EndElements\n";

#[test]
fn a_level_that_would_invert_tets_is_refused_and_nothing_written() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = folder.path().join("folding.msh");
    std::fs::write(&mesh, FOLDING).unwrap();
    let config = "name = \"folding\"\n[[stage]]\nkind = \"import\"\npath = \"folding.msh\"\n\
        [[stage]]\nkind = \"check\"\n[[stage]]\nkind = \"subdivide\"\nlevels = 2\n\
        crease-angle = 180\ninterpolate = false\n\
        min-quality = \"off\"\n[[stage]]\nkind = \"write\"\n";
    std::fs::write(folder.path().join("c.toml"), config).unwrap();
    let before = files(folder.path());
    let refine = "refine folding.msh out.vtu --scheme box-spline --levels 2 --crease-angle 180 \
                  --interpolate=false";
    let unguarded = format!("{refine} --min-quality off");
    for arguments in [&unguarded, "run c.toml"] {
        let arguments: Vec<&str> = arguments.split(' ').collect();
        let output = octruss(folder.path(), &[&arguments[..], &["--quiet"]].concat());
        let message = stderr(&output);
        assert_eq!(code(&output), 1, "{message}");
        let says = "error: stage `subdivide`: level 2 would invert 1 of 128 tets (the first: ";
        assert!(message.starts_with(says), "{message}");
        assert_eq!(files(folder.path()), before);
    }
    // The guard that holds unless it is switched off keeps the volume positive,
    // as does a lower floor.
    let arguments: Vec<&str> = refine.split(' ').collect();
    succeed(folder.path(), &arguments);
    succeed(folder.path(), &[&arguments[..], &["--min-quality", "0.05"]].concat());
}
