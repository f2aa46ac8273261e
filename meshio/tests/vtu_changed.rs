//! Tags and features of a file whose mesh another program changed since.

use octruss_mesh::{CellState, Features, Group, shapes};
use octruss_meshio::{Dataset, read, vtu};

/// One tet as ASCII VTU with these arrays beside the cells.
fn tet_with(arrays: &[(&str, &str, usize, &str)]) -> Dataset {
    let arrays: String = arrays
        .iter()
        .map(|(kind, name, components, values)| {
            format!(
                "<DataArray type=\"{kind}\" Name=\"octruss:{name}\" \
                 NumberOfComponents=\"{components}\" format=\"ascii\">{values}</DataArray>\n"
            )
        })
        .collect();
    let text = format!(
        r#"<VTKFile type="UnstructuredGrid"><UnstructuredGrid><FieldData>{arrays}</FieldData>
<Piece NumberOfPoints="4" NumberOfCells="1">
<Points><DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>"#
    );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tet.vtu");
    std::fs::write(&path, text).unwrap();
    read(&path).unwrap()
}

fn assert_left_out(dataset: &Dataset, what: &str) {
    let mesh = &dataset.mesh;
    assert!(mesh.triangles.is_empty() && mesh.edges.is_empty(), "{what}");
    assert!(mesh.vertices.is_empty() && mesh.features.is_none(), "{what}");
    assert_eq!(dataset.notes.len(), 1, "{what}");
    assert!(dataset.notes[0].starts_with("The mesh was changed by another program"), "{what}");
}

const TRIANGLE: [(&str, &str, usize, &str); 2] =
    [("UInt32", "triangles", 3, "0 1 2"), ("Int32", "triangle_tags", 1, "5")];

#[test]
fn a_moved_point_leaves_group_names_alone() {
    let mut mesh = shapes::kuhn_cube(2).into_raw();
    mesh.points[5][0] = 0.625;
    mesh.groups = vec![Group { dimension: 2, id: 1, name: "inlet".into() }];
    mesh.features = Some(Features::default());
    let sound = Dataset { mesh, ..Dataset::default() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cube.vtu");
    vtu::write(&path, &sound).unwrap();
    assert_eq!(read(&path).unwrap(), sound);
    let mut bytes = std::fs::read(&path).unwrap();
    let place = bytes.windows(8).position(|word| word == 0.625_f64.to_ne_bytes()).unwrap();
    bytes[place..place + 8].copy_from_slice(&0.75_f64.to_ne_bytes());
    std::fs::write(&path, bytes).unwrap();
    let found = read(&path).unwrap();
    assert_left_out(&found, "a point moved");
    assert_eq!(found.mesh.groups, sound.mesh.groups);
    assert_eq!((found.mesh.points[5][0], found.mesh.tets), (0.75, sound.mesh.tets));
}

#[test]
fn tags_with_the_fingerprint_of_another_mesh_are_left_out() {
    for fingerprint in ["4 1 0 0", "5 2 3 4", "7", ""] {
        let [triangles, tags] = TRIANGLE;
        let found = tet_with(&[triangles, tags, ("UInt32", "fingerprint", 1, fingerprint)]);
        assert_left_out(&found, fingerprint);
    }
}

#[test]
fn tags_without_a_fingerprint_are_believed_if_they_fit() {
    let found = tet_with(&TRIANGLE);
    assert_eq!(found.mesh.triangles.simplices, [[0, 1, 2]]);
    assert_eq!(found.notes, [] as [&str; 0]);
    let features = |creases, corners, states| {
        let surfaces = ("Int32", "feature_surfaces", 1, "");
        let creases = ("UInt32", "creases", 2, creases);
        let corners = ("UInt32", "corners", 1, corners);
        tet_with(&[creases, corners, surfaces, ("UInt8", "cell_states", 1, states)])
    };
    assert_eq!(features("0 1", "3", "1").notes, [] as [&str; 0]);
    for (what, found) in [
        ("triangle", tet_with(&[("UInt32", "triangles", 3, "0 1 4"), TRIANGLE[1]])),
        ("edge", tet_with(&[("UInt32", "edges", 2, "0 9"), ("Int32", "edge_tags", 1, "5")])),
        ("vertex", tet_with(&[("UInt32", "vertices", 1, "4"), ("Int32", "vertex_tags", 1, "5")])),
        ("crease", features("0 4", "3", "1")),
        ("corner", features("0 1", "4", "1")),
        ("states", features("0 1", "3", "1 0")),
    ] {
        assert_left_out(&found, what);
    }
}

#[test]
fn features_in_any_order_are_sorted() {
    let found = tet_with(&[
        ("UInt32", "creases", 2, "3 1 0 2 1 3 1 0"),
        ("UInt32", "corners", 1, "3 0 3"),
        ("Int32", "feature_surfaces", 1, "7 -2 7 1"),
        ("UInt8", "cell_states", 1, "2"),
    ]);
    let expected = Features {
        initial_quality: None,
        creases: vec![[0, 1], [0, 2], [1, 3]],
        corners: vec![0, 3],
        surfaces: vec![-2, 1, 7],
        mirrors: vec![],
        cell_states: vec![CellState::QuarterRoundX1X3],
        smoothed: false,
        control_points: None,
    };
    assert_eq!(found.mesh.features, Some(expected));
}
