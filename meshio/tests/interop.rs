//! VTK and meshio read what we write, and we read what they write, exactly.
//!
//! Both come from PyPI into an environment of their own under the target
//! folder, once. Without Python or a network these tests say so on the terminal,
//! past the capture of the test harness, and pass; where `CI` is `true`, they fail.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use octruss_mesh::{Features, Group, RawMesh, shapes};
use octruss_meshio::vtu::{Compression, VtuOptions};
use octruss_meshio::{Dataset, Field, Values, legacy, medit, read, vtu};

/// The Python that has VTK and meshio; the error says why there is none.
fn python() -> Result<&'static Path, &'static str> {
    static PYTHON: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    let python = PYTHON.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("interop-venv");
        let (python, ready) = (folder.join("bin/python"), folder.join("ready"));
        if !ready.exists() {
            run(Command::new("python3").args(["-m", "venv"]).arg(&folder))?;
            run(Command::new(&python).args(["-m", "pip", "install", "-q", "vtk", "meshio"]))?;
            std::fs::write(ready, "").map_err(|reason| reason.to_string())?;
        }
        Ok(python)
    });
    python.as_deref().map_err(String::as_str)
}

fn run(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|reason| format!("{command:?}: {reason}"))?;
    if output.status.success() {
        return Ok(());
    }
    Err(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr)))
}

/// Runs a task of the script beside this file; false if there is no Python for it.
fn script(task: &str, file: &Path, target: &Path) -> bool {
    match python() {
        Ok(python) => {
            let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/interop_vtk.py");
            run(Command::new(python).arg(script).arg(task).arg(file).arg(target)).unwrap();
            true
        }
        Err(reason) if std::env::var("CI").is_ok_and(|value| value == "true") => {
            panic!("comparing with VTK and meshio needs Python and PyPI: {reason}")
        }
        Err(reason) => {
            // Not eprintln!, which the test harness hides where tests pass.
            let _ = writeln!(
                std::io::stderr(),
                "SKIPPED: comparing with VTK and meshio needs Python and PyPI: {reason}"
            );
            false
        }
    }
}

/// A mesh of a cube of `cells`³ with everything that a file of ours can hold;
/// values of fields are multiples of 1/`parts`.
fn rich_dataset(cells: u32, parts: f64) -> Dataset {
    let mut mesh = shapes::kuhn_cube(cells).into_raw();
    for (index, region) in mesh.regions.iter_mut().enumerate() {
        *region = [1, 5, -2][index % 3];
    }
    mesh.edges.push([0, 1], 4);
    mesh.vertices.push([63], 9);
    mesh.groups.push(Group { dimension: 3, id: 1, name: "Gehäuse <a> & \"b\"".into() });
    mesh.groups.push(Group { dimension: 1, id: 4, name: String::new() });
    mesh.features = Some(Features {
        initial_quality: Some(0.1),
        creases: vec![[0, 1], [1, 2]],
        corners: vec![],
        surfaces: vec![6],
        mirrors: vec![],
        cell_states: vec![],
        smoothed: false,
        control_points: None,
    });
    let float = |count: usize| Values::Float((0..count).map(|i| i as f64 / parts - 3.0).collect());
    let whole = |count: usize| Values::Integer((0..count as i64).map(|i| (i - 9) << 40).collect());
    let (points, tets) = (mesh.points.len(), mesh.tets.len());
    let field = |name: &str, components, values| Field::new(name, components, values);
    Dataset {
        mesh,
        point_fields: vec![
            field("u", 1, float(points)),
            field("displacement", 3, float(3 * points)),
            field("number of point", 1, whole(points)),
        ],
        cell_fields: vec![field("σ", 9, float(9 * tets)), field("pair", 2, whole(2 * tets))],
        ..Dataset::default()
    }
}

/// The lines that the script writes about an array.
fn line(place: &str, name: &str, components: usize, values: &Values) -> String {
    let words: Vec<String> = match values {
        Values::Float(values) => values.iter().map(|v| format!("{:016x}", v.to_bits())).collect(),
        Values::Integer(values) => values.iter().map(i64::to_string).collect(),
    };
    [place, name, &components.to_string(), &words.join(" ")].join("\t")
}

fn wholes<T: Copy + Into<i64>>(values: &[T]) -> Values {
    Values::Integer(values.iter().map(|&value| value.into()).collect())
}

fn mesh_lines(mesh: &RawMesh, vertices: &[u32], sizes: &[i64], types: &[u8]) -> Vec<String> {
    let mut ends = vec![0];
    for size in sizes {
        ends.push(ends[ends.len() - 1] + size);
    }
    vec![
        line("mesh", "points", 3, &Values::Float(mesh.points.as_flattened().to_vec())),
        line("mesh", "connectivity", 1, &wholes(vertices)),
        line("mesh", "offsets", 1, &wholes(&ends)),
        line("mesh", "types", 1, &wholes(types)),
    ]
}

fn field_lines(place: &str, fields: &[Field]) -> Vec<String> {
    fields.iter().map(|f| line(place, &f.name, f.components, &f.values)).collect()
}

fn names_line(names: &[&str]) -> String {
    let bytes: Vec<u8> = names.iter().flat_map(|name| name.bytes().chain([0])).collect();
    line("file", "octruss:group_names", 1, &wholes(&bytes))
}

fn side_lines(mesh: &RawMesh) -> Vec<String> {
    let array = |name: &str, components, values| {
        line("file", &format!("octruss:{name}"), components, &values)
    };
    let features = mesh.features.as_ref().unwrap();
    let dimensions: Vec<u8> = mesh.groups.iter().map(|group| group.dimension).collect();
    let ids: Vec<i32> = mesh.groups.iter().map(|group| group.id).collect();
    let mut lines = vec![
        array("group_dimensions", 1, wholes(&dimensions)),
        array("group_ids", 1, wholes(&ids)),
        array("triangles", 3, wholes(mesh.triangles.simplices.as_flattened())),
        array("triangle_tags", 1, wholes(&mesh.triangles.tags)),
        array("edges", 2, wholes(mesh.edges.simplices.as_flattened())),
        array("edge_tags", 1, wholes(&mesh.edges.tags)),
        array("vertices", 1, wholes(mesh.vertices.simplices.as_flattened())),
        array("vertex_tags", 1, wholes(&mesh.vertices.tags)),
        array("creases", 2, wholes(features.creases.as_flattened())),
        array("corners", 1, wholes(&features.corners)),
        array("feature_surfaces", 1, wholes(&features.surfaces)),
        // 0.1 in the bytes of a double, the lowest first.
        array("initial_quality", 1, wholes(&[154u8, 153, 153, 153, 153, 153, 185, 63])),
    ];
    let names: Vec<&str> = mesh.groups.iter().map(|group| group.name.as_str()).collect();
    lines.push(names_line(&names));
    lines
}

/// Compares what the script found, in any order.
fn assert_dump(task: &str, file: &Path, mut expected: Vec<String>) {
    let dump = file.with_extension("dump");
    if !script(task, file, &dump) {
        return;
    }
    let text = std::fs::read_to_string(&dump).unwrap();
    let mut found: Vec<&str> = text.lines().collect();
    // A checksum, whose value only our reader compares.
    found.retain(|line| !line.starts_with("file\toctruss:fingerprint\t"));
    found.sort_unstable();
    expected.sort_unstable();
    let name = |line: &str| line.split('\t').take(3).collect::<Vec<_>>().join(" ");
    let names = |lines: &[&str]| lines.iter().map(|line| name(line)).collect::<Vec<_>>();
    let expected: Vec<&str> = expected.iter().map(String::as_str).collect();
    assert_eq!(names(&found), names(&expected), "{}", file.display());
    for (found, expected) in found.into_iter().zip(expected) {
        assert!(found == expected, "{} differs in {}", name(expected), file.display());
    }
}

#[test]
fn vtk_and_meshio_read_our_vtu() {
    let folder = tempfile::tempdir().unwrap();
    // meshio rewrites offsets of compressed arrays while it looks for others by
    // their offsets, and in some files takes one for the other; not in this one.
    let dataset = rich_dataset(3, 9.0);
    let mesh = &dataset.mesh;
    let tets = mesh.tets.len();
    for (name, compression) in [("raw", Compression::None), ("zlib", Compression::Zlib(1))] {
        let path = folder.path().join(name).with_extension("vtu");
        vtu::write_with(&path, &dataset, &VtuOptions { compression }).unwrap();
        let sides = side_lines(mesh);
        let fields = [
            field_lines("point", &dataset.point_fields),
            field_lines("cell", &dataset.cell_fields),
            vec![line("cell", "region", 1, &wholes(&mesh.regions))],
        ]
        .concat();
        let cells = mesh_lines(mesh, mesh.tets.as_flattened(), &vec![4; tets], &vec![10; tets]);
        assert_dump("dump", &path, [cells, fields.clone(), sides].concat());
        let cells = vec![
            line("mesh", "points", 3, &Values::Float(mesh.points.as_flattened().to_vec())),
            line("mesh", "tetra", 4, &wholes(mesh.tets.as_flattened())),
        ];
        assert_dump("dump-meshio", &path, [cells, fields].concat());
    }
}

#[test]
fn vtk_reads_our_surfaces() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cube.surfaces.vtu");
    // Two cells a side, hence one vertex inside, number 13, that no triangle uses.
    let dataset = Dataset { mesh: shapes::kuhn_cube(2).into_raw(), ..Dataset::default() };
    vtu::write_surfaces(&path, &dataset).unwrap();
    let mut mesh = RawMesh { points: dataset.mesh.points.clone(), ..RawMesh::default() };
    mesh.points.remove(13);
    let shift = |v: u32| if v > 13 { v - 1 } else { v };
    let vertices: Vec<u32> =
        dataset.mesh.triangles.simplices.as_flattened().iter().map(|&v| shift(v)).collect();
    let mut expected = mesh_lines(&mesh, &vertices, &[3; 48], &[5; 48]);
    expected.push(line("cell", "surface", 1, &wholes(&dataset.mesh.triangles.tags)));
    expected.push(line("file", "octruss:group_dimensions", 1, &wholes(&[2; 6])));
    expected.push(line("file", "octruss:group_ids", 1, &wholes(&[1, 2, 3, 4, 5, 6])));
    expected.push(names_line(&["x0", "x1", "y0", "y1", "z0", "z1"]));
    assert_dump("dump", &path, expected);
}

#[test]
fn vtk_reads_our_legacy_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mesh.vtk");
    let dataset = rich_dataset(3, 7.0);
    legacy::write(&path, &dataset).unwrap();
    let mesh = &dataset.mesh;
    let (tets, triangles) = (mesh.tets.len(), mesh.triangles.len());
    let vertices = [mesh.tets.as_flattened(), mesh.triangles.simplices.as_flattened(), &[0, 1, 63]];
    let sizes = [vec![4; tets], vec![3; triangles], vec![2, 1]].concat();
    let types = [vec![10; tets], vec![5; triangles], vec![3, 1]].concat();
    let regions = [&mesh.regions[..], &mesh.triangles.tags, &[4, 9]].concat();
    let mut cell_fields = dataset.cell_fields.clone();
    for field in &mut cell_fields {
        let more = field.components * (triangles + 2);
        match &mut field.values {
            Values::Float(values) => values.resize(values.len() + more, f64::NAN),
            Values::Integer(values) => values.resize(values.len() + more, 0),
        }
    }
    let expected = [
        mesh_lines(mesh, &vertices.concat(), &sizes, &types),
        field_lines("point", &dataset.point_fields),
        field_lines("cell", &cell_fields),
        vec![line("cell", "region", 1, &wholes(&regions))],
    ];
    assert_dump("dump", &path, expected.concat());
}

#[test]
fn meshio_reads_our_medit_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cube.mesh");
    let dataset = rich_dataset(3, 7.0);
    medit::write(&path, &dataset).unwrap();
    let mesh = &dataset.mesh;
    let references = |values: &[i32]| line("cell", "medit:ref", 1, &wholes(values));
    let expected = vec![
        line("mesh", "points", 3, &Values::Float(mesh.points.as_flattened().to_vec())),
        line("point", "medit:ref", 1, &wholes(&vec![0; mesh.points.len()])),
        line("mesh", "tetra", 4, &wholes(mesh.tets.as_flattened())),
        references(&mesh.regions),
        line("mesh", "triangle", 3, &wholes(mesh.triangles.simplices.as_flattened())),
        references(&mesh.triangles.tags),
        line("mesh", "line", 2, &wholes(mesh.edges.simplices.as_flattened())),
        references(&mesh.edges.tags),
    ];
    assert_dump("dump-meshio", &path, expected);
}

#[test]
fn we_read_what_vtk_and_meshio_write() {
    // meshio, and VTK in legacy files, round in ASCII; both hold eighths exactly.
    let exact =
        |name: &str| !["ascii.vtk", "meshio-ascii.vtu"].iter().any(|end| name.ends_with(end));
    assert_theirs(&rich_dataset(3, 7.0), exact, 32 + 2 + 3);
    assert_theirs(&rich_dataset(4, 8.0), |_| true, 32 + 4 + 4);
}

#[test]
fn tags_are_left_out_after_a_filter_of_vtk() {
    let folder = tempfile::tempdir().unwrap();
    let [ours, theirs] = ["ours.vtu", "theirs.vtu"].map(|name| folder.path().join(name));
    let dataset = rich_dataset(3, 7.0);
    vtu::write(&ours, &dataset).unwrap();
    if !script("threshold", &ours, &theirs) {
        return;
    }
    let found = read(&theirs).unwrap();
    // Every third of 6 · 27 tets is in region 5.
    assert_eq!(found.mesh.regions, [5; 54]);
    assert!(found.mesh.triangles.is_empty() && found.mesh.features.is_none());
    assert_eq!(found.mesh.groups, dataset.mesh.groups);
    let changed = |note: &&String| note.starts_with("The mesh was changed by another program");
    assert_eq!(found.notes.iter().filter(changed).count(), 1, "{:?}", found.notes);
}

/// Compares what we read from the files that VTK and meshio make of a dataset:
/// four modes, two compressors, two header types and two byte orders of VTU;
/// two versions and two modes of legacy files; four of meshio, a Medit file among
/// them.
fn assert_theirs(dataset: &Dataset, compared: fn(&str) -> bool, expected_count: usize) {
    let folder = tempfile::tempdir().unwrap();
    let ours = folder.path().join("ours.vtu");
    let theirs = folder.path().join("theirs");
    std::fs::create_dir(&theirs).unwrap();
    vtu::write(&ours, dataset).unwrap();
    if !script("convert", &ours, &theirs) {
        return;
    }
    // Only VTK's own XML files carry what belongs to the file as a whole.
    let mut bare = dataset.clone();
    let RawMesh { points, tets, regions, .. } = bare.mesh;
    bare.mesh = RawMesh { points, tets, regions, ..RawMesh::default() };
    let mut count = 0;
    for entry in std::fs::read_dir(&theirs).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if compared(&name) {
            let mut found = read(&path).unwrap();
            let whole = name.starts_with("vtk-") && name.ends_with(".vtu");
            let mut expected = if whole { dataset.clone() } else { bare.clone() };
            if name.ends_with(".mesh") {
                expected.point_fields.clear();
                expected.cell_fields.clear();
            }
            sort_fields(&mut found);
            sort_fields(&mut expected);
            assert!(found == expected, "{name} differs");
            count += 1;
        }
    }
    assert_eq!(count, expected_count);
}

/// meshio sorts arrays by their kind; only we promise an order.
fn sort_fields(dataset: &mut Dataset) {
    dataset.point_fields.sort_by(|a, b| a.name.cmp(&b.name));
    dataset.cell_fields.sort_by(|a, b| a.name.cmp(&b.name));
}
