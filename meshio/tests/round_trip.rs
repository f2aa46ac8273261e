//! What is written comes back: the same data, bit for bit.

use std::path::Path;

use octruss_mesh::{
    CellState, ControlPoints, CurveEnds, Features, Group, Level, Placement, RawMesh, Tagged, shapes,
};
use octruss_meshio::vtu::{Compression, VtuOptions};
use octruss_meshio::{
    Dataset, Error, Field, Format, Values, legacy, medit, read, vtu, write_aside,
};

/// A way to write a dataset, and what its format cannot hold.
struct Way {
    name: &'static str,
    extension: &'static str,
    write: fn(&Path, &Dataset) -> Result<(), Error>,
    keeps: Keeps,
}

#[derive(PartialEq)]
enum Keeps {
    Everything,
    /// All but group names, features and which fields are derived.
    Tags,
    /// Points, tets, regions, tagged triangles and edges.
    Simplices,
}

const WAYS: [Way; 5] = [
    Way { name: "vtu", extension: "vtu", write: vtu::write, keeps: Keeps::Everything },
    Way { name: "vtu zlib 1", extension: "vtu", write: zlib::<1>, keeps: Keeps::Everything },
    Way { name: "vtu zlib 9", extension: "vtu", write: zlib::<9>, keeps: Keeps::Everything },
    Way { name: "legacy", extension: "vtk", write: legacy::write, keeps: Keeps::Tags },
    Way { name: "Medit", extension: "mesh", write: medit::write, keeps: Keeps::Simplices },
];

fn zlib<const LEVEL: u32>(path: &Path, dataset: &Dataset) -> Result<(), Error> {
    vtu::write_with(path, dataset, &VtuOptions { compression: Compression::Zlib(LEVEL) })
}

/// Writes and reads `dataset` in every way and compares; it must stay untouched.
fn assert_round_trips(dataset: &Dataset) {
    let folder = tempfile::tempdir().unwrap();
    let before = dataset.clone();
    for way in &WAYS {
        let path = folder.path().join("mesh").with_extension(way.extension);
        (way.write)(&path, dataset).unwrap();
        assert_eq!(*dataset, before, "{}: writing changed its input", way.name);
        let mut expected = dataset.clone();
        expected.notes.clear();
        if way.keeps == Keeps::Simplices {
            expected.mesh.vertices = Tagged::default();
            expected.point_fields.clear();
            expected.cell_fields.clear();
        }
        if way.keeps != Keeps::Everything {
            expected.mesh.groups.clear();
            expected.mesh.features = None;
            let fields = expected.point_fields.iter_mut().chain(&mut expected.cell_fields);
            fields.for_each(|field| field.derived = false);
        }
        let found = read(&path).unwrap();
        assert_eq!(found, expected, "{}", way.name);
        let files = std::fs::read_dir(folder.path()).unwrap().count();
        std::fs::remove_file(&path).unwrap();
        assert_eq!(files, 1, "{}: something was left behind", way.name);
    }
}

fn group(dimension: u8, id: i32, name: &str) -> Group {
    Group { dimension, id, name: name.into() }
}

/// Two regions, tagged simplices of every dimension, some standing free, one in
/// two groups; names in several scripts.
fn tagged_cube() -> Dataset {
    let mut mesh = shapes::kuhn_cube(2).into_raw();
    for (index, region) in mesh.regions.iter_mut().enumerate() {
        *region = [1, -7][index % 2];
    }
    let free = mesh.points.len() as u32;
    mesh.points.extend([[2.0, 0.0, 0.0], [3.0, 0.0, 0.0], [2.0, 1.0, 0.0]]);
    mesh.triangles.push([free, free + 1, free + 2], i32::MAX);
    mesh.triangles.push([free + 2, free + 1, free], 2);
    mesh.edges.push([0, 1], 4);
    mesh.edges.push([free + 1, free], i32::MIN);
    mesh.vertices.push([0], 9);
    mesh.vertices.push([free], 8);
    mesh.groups.extend([
        group(3, 1, "Gehäuse"),
        group(3, -7, "コア <&\">'\n\t"),
        group(1, 4, "Kante mit Leerzeichen"),
        group(0, 9, ""),
        group(0, 9, "point \u{1F600}"),
    ]);
    Dataset { mesh, notes: vec!["a remark".into()], ..Dataset::default() }
}

fn floats(count: usize) -> Values {
    let special = [0.1, -0.0, f64::INFINITY, f64::MIN_POSITIVE / 8.0, f64::MAX, 1.0 / 3.0];
    Values::Float((0..count).map(|i| special[i % special.len()] * (i + 1) as f64).collect())
}

fn integers(count: usize) -> Values {
    let special = [i64::MAX, i64::MIN, 0, -1, 1 << 53, 42];
    Values::Integer((0..count).map(|i| special[i % special.len()]).collect())
}

/// Fields of either kind with 1, 2, 3 and 9 components on `tuples` points or tets.
fn fields(tuples: usize) -> Vec<Field> {
    let mut fields = Vec::new();
    for components in [1, 2, 3, 9] {
        for (kind, values) in [("float", floats as fn(usize) -> Values), ("integer", integers)] {
            let name = format!("{kind} ×{components} <&\"%>");
            let values = values(components * tuples);
            fields.push(Field { derived: components == 3, ..Field::new(name, components, values) });
        }
    }
    fields
}

#[test]
fn shapes_come_back() {
    for mesh in [shapes::regular_tet(), shapes::five_tet_cube(), shapes::kuhn_cube(3)] {
        assert_round_trips(&Dataset { mesh: mesh.into_raw(), ..Dataset::default() });
    }
}

#[test]
fn regions_tags_and_names_come_back() {
    assert_round_trips(&tagged_cube());
}

#[test]
fn fields_come_back() {
    let mut dataset = tagged_cube();
    dataset.point_fields = fields(dataset.mesh.points.len());
    dataset.cell_fields = fields(dataset.mesh.tets.len());
    assert_round_trips(&dataset);
}

#[test]
fn features_come_back_even_if_there_are_none() {
    let mut dataset = tagged_cube();
    use CellState::{QuarterRoundX0X2, QuarterRoundX1X3, Tetrahedron};
    let states = [Tetrahedron, QuarterRoundX0X2, QuarterRoundX1X3].repeat(16);
    for features in [
        None,
        Some(Features::default()),
        Some(Features {
            initial_quality: Some(0.1),
            creases: vec![[0, 1], [0, 3]],
            corners: vec![0, 5],
            surfaces: vec![2],
            mirrors: vec![-3, 1],
            cell_states: states,
            smoothed: false,
            control_points: None,
        }),
        Some(Features {
            control_points: Some(ControlPoints {
                curve_ends: CurveEnds::Parabola,
                vertices: vec![0, 2, 3],
                positions: vec![[0.1, -0.0, 1e-300], [f64::MAX, 0.2, 1.0 / 3.0], [1.0; 3]],
                placement: Placement::AtLimit,
            }),
            ..Features::default()
        }),
        Some(Features { corners: vec![7], ..Features::default() }),
    ] {
        dataset.mesh.features = features;
        assert_round_trips(&dataset);
    }
}

#[test]
fn little_or_nothing_comes_back() {
    assert_round_trips(&Dataset::default());
    let points = vec![[0.5, 1.5, 2.5], [f64::MAX, -0.0, 1e-300]];
    let mesh = RawMesh { points, groups: vec![group(2, 3, "unused")], ..RawMesh::default() };
    let mut dataset = Dataset { mesh, ..Dataset::default() };
    assert_round_trips(&dataset);
    dataset.point_fields = fields(2);
    dataset.cell_fields = fields(0);
    assert_round_trips(&dataset);
    dataset.mesh.triangles.push([0, 1, 0], 3);
    assert_round_trips(&dataset);
}

#[test]
fn a_field_without_tuples_may_have_any_number_of_components() {
    // As doubles, a tuple would have 2⁶⁴ bytes, which wraps round to none.
    let field = Field::new("u", 1 << 61, Values::Float(vec![]));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("empty.vtu");
    vtu::write(&path, &Dataset { point_fields: vec![field], ..Dataset::default() }).unwrap();
    assert!(path.exists());
}

#[test]
fn arrays_of_many_blocks_come_back() {
    let mesh = shapes::kuhn_cube(12).into_raw();
    let mut dataset = Dataset { mesh, ..Dataset::default() };
    dataset.point_fields = fields(dataset.mesh.points.len());
    assert_round_trips(&dataset);
}

#[test]
fn vertex_numbers_beyond_the_points_come_back() {
    let mesh = RawMesh {
        tets: vec![[0, 1, 2, u32::MAX], [i32::MAX as u32, i32::MAX as u32 + 1, 7, 8]],
        regions: vec![0, 1],
        ..RawMesh::default()
    };
    let dataset = Dataset { mesh, ..Dataset::default() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wide.vtu");
    vtu::write(&path, &dataset).unwrap();
    assert_eq!(read(&path).unwrap(), dataset);
    let refused = legacy::write(&folder.path().join("wide.vtk"), &dataset).unwrap_err();
    assert!(refused.to_string().contains("32 bits"), "{refused}");
    let refused = medit::write(&folder.path().join("wide.mesh"), &dataset).unwrap_err();
    assert!(refused.to_string().contains("a tet has the vertex 0, but there are 0"), "{refused}");
}

#[test]
fn a_format_says_what_it_loses() {
    let mut dataset = tagged_cube();
    dataset.mesh.features = Some(Features::default());
    dataset.point_fields = vec![Field::scalar("height", vec![0.0; 30])];
    let losses = |name: &str| Format::of(name.as_ref()).unwrap().losses(&dataset);
    assert!(losses("a.vtu").is_empty());
    let legacy = losses("a.vtk");
    assert_eq!(legacy.len(), 2);
    assert!(legacy[0].contains("group names") && legacy[1].contains("features"));
    assert_eq!(
        losses("a.mesh"),
        [
            "Medit files hold no group names; groups keep their ids only.",
            "Medit files hold no groups of points: 2 tagged vertices left out.",
            "Medit files hold no features; they will be found anew.",
            "Medit files hold no fields: height left out.",
        ]
    );
}

#[test]
fn contradictions_are_refused_and_nothing_is_written() {
    let cube = tagged_cube();
    let with = |change: fn(&mut Dataset)| {
        let mut dataset = cube.clone();
        change(&mut dataset);
        dataset
    };
    let field = |name: &str, tets: usize| Field::scalar(name, vec![0.0; tets]);
    let named = |name: &str| {
        let mut dataset = cube.clone();
        dataset.cell_fields = vec![field(name, cube.mesh.tets.len())];
        dataset
    };
    let folder = tempfile::tempdir().unwrap();
    for (dataset, expected) in [
        (with(|d| d.mesh.regions.truncate(3)), "3 regions for the tets, which are 48"),
        (with(|d| d.mesh.edges.tags.clear()), "0 tags for the edges, which are 2"),
        (with(|d| d.point_fields = vec![Field::scalar("u", vec![1.0])]), "`u` has 1 values, not 1"),
        (
            with(|d| d.cell_fields = vec![Field::scalar("u", vec![0.0; 48]); 2]),
            "called `u`; rename",
        ),
    ] {
        for extension in ["vtu", "vtk", "mesh"] {
            let path = folder.path().join("refused").with_extension(extension);
            let message = octruss_meshio::write(&path, &dataset).unwrap_err().to_string();
            assert!(message.contains(expected), "{extension}: {message}");
        }
    }
    for path in [folder.path().join("a.vtu"), folder.path().join("a.vtk")] {
        let message = octruss_meshio::write(&path, &named("region")).unwrap_err().to_string();
        assert!(message.contains("called `region`"), "{message}");
    }
    let message = vtu::write(&folder.path().join("a.vtu"), &named("a\u{1}")).unwrap_err();
    assert!(message.to_string().contains("control character"), "{message}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_folder_that_cannot_take_the_file_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let no_folder = folder.path().join("file");
    std::fs::write(&no_folder, "").unwrap();
    for (path, expected) in [
        (folder.path().join("absent/out.vtu"), "absent: the folder does not exist; create it"),
        (no_folder.join("out.vtu"), "file: this is not a folder"),
    ] {
        let message = vtu::write(&path, &tagged_cube()).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn a_failed_write_leaves_the_old_file_alone() {
    use std::io::{Error, Write};
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("kept.txt");
    std::fs::write(&path, "old").unwrap();
    let failed = write_aside(&path, |file| {
        file.write_all(b"half of the new")?;
        Err(Error::other("disk full"))
    });
    assert!(failed.unwrap_err().to_string().contains("disk full"));
    assert_eq!(std::fs::read(&path).unwrap(), b"old");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn files_have_the_usual_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let mode = |path: &Path| std::fs::metadata(path).unwrap().permissions().mode() & 0o777;
    let plain = folder.path().join("plain");
    std::fs::write(&plain, "").unwrap();
    let ours = folder.path().join("ours.vtu");
    vtu::write(&ours, &Dataset::default()).unwrap();
    assert_eq!(mode(&ours), mode(&plain));
    std::fs::set_permissions(&ours, std::fs::Permissions::from_mode(0o640)).unwrap();
    vtu::write(&ours, &Dataset::default()).unwrap();
    assert_eq!(mode(&ours), 0o640, "a replaced file keeps its permissions");
}

#[test]
fn surfaces_go_beside_the_mesh_with_the_points_they_use() {
    let mut dataset = tagged_cube();
    let x = |dataset: &Dataset| dataset.mesh.points.iter().map(|p| p[0]).collect();
    dataset.point_fields = vec![Field::scalar("x", x(&dataset))];
    let folder = tempfile::tempdir().unwrap();
    let path = vtu::surfaces_path(&folder.path().join("cube.vtu"));
    vtu::write_surfaces(&path, &dataset).unwrap();
    // Our reader leaves triangles out that it finds no tags for: `surface` is
    // for viewers, the mesh's own file for reading.
    let text = String::from_utf8_lossy(&std::fs::read(&path).unwrap()).into_owned();
    // The cube's 27 vertices without the one inside, and three free ones; 48
    // triangles of the cube and two free ones.
    assert!(text.contains("<Piece NumberOfPoints=\"29\" NumberOfCells=\"50\">"), "{text}");
    let found = read(&path).unwrap();
    assert_eq!(found.point_fields, [Field::scalar("x", x(&found))]);
    assert_eq!(found.mesh.group_names(2), ["x0", "x1", "y0", "y1", "z0", "z1"]);
}

#[test]
fn features_become_vertices_and_lines_with_their_reasons() {
    use octruss_mesh::{FeatureOptions, FeatureReasons, Hierarchy};
    let options = FeatureOptions::default();
    let cube = Hierarchy::new(shapes::kuhn_cube(2), &options);
    let Level { mesh, topology, .. } = cube.coarsest();
    let reasons = FeatureReasons::new(mesh, topology, Some(&options));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("features.vtu");
    vtu::write_features(&path, mesh, &reasons).unwrap();
    let found = read(&path).unwrap();
    // The 8 corners and 12 edges of the cube, two mesh edges each; cells without
    // tags are no part of a mesh.
    assert_eq!(found.mesh.points.len(), 20);
    assert!(found.mesh.points.iter().all(|p| p.iter().filter(|x| **x == 0.5).count() <= 1));
    assert_eq!(found.notes, ["32 triangles, lines or vertices without a tag were left out."]);
    assert_eq!(found.mesh.group_names(0), ["curves-meet"]);
    assert_eq!(found.mesh.group_names(1), ["group-border"]);

    vtu::write_features(&path, mesh, &FeatureReasons::default()).unwrap();
    let empty = read(&path).unwrap();
    assert_eq!((empty.mesh, empty.notes), (RawMesh::default(), vec![]));
    // Those of a larger mesh.
    let refused = vtu::write_features(&path, &shapes::regular_tet(), &reasons).unwrap_err();
    assert!(refused.to_string().contains("a feature has the vertex 26, but there are 4"));
}
