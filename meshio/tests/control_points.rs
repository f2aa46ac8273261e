//! Control points that go with a mesh through a file.

use octruss_mesh::{
    CheckOptions, ControlPoints, CurveEnds, Hierarchy, Placement, Scheme, Step, TetMesh, check,
    shapes,
};
use octruss_meshio::{Dataset, read, vtu};

const THROUGH: Step = Step {
    scheme: Scheme::BoxSpline,
    diagonal: octruss_mesh::Diagonal::Inherit,
    min_quality: None,
    interpolate: true,
    project_limit: false,
    curve_ends: None,
};

fn refined(mesh: TetMesh, levels: usize) -> TetMesh {
    let options = octruss_mesh::FeatureOptions { crease_angle: 180.0, ..Default::default() };
    let mut hierarchy = Hierarchy::new(mesh, &options);
    for _ in 0..levels {
        hierarchy.subdivide(THROUGH).unwrap();
    }
    hierarchy.into_finest().mesh
}

#[test]
fn refining_again_what_a_file_holds_is_refining_by_two_levels() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("once.vtu");
    let once = refined(shapes::kuhn_cube(2), 1);
    assert!(once.features().unwrap().control_points.is_some());
    vtu::write(&path, &Dataset { mesh: once.raw().clone(), ..Dataset::default() }).unwrap();
    let found = check(read(&path).unwrap().mesh, &CheckOptions::default()).unwrap().mesh;
    assert!(found == once);
    assert!(refined(found, 1) == refined(shapes::kuhn_cube(2), 2));
}

/// One tet with these bytes as control points of these vertices, as ASCII VTU.
fn tet_with(vertices: &str, bytes: &[u8], placement: &str) -> Result<Dataset, String> {
    let bytes = bytes.iter().map(u8::to_string).collect::<Vec<_>>().join(" ");
    let array = |kind: &str, name: &str, values: &str| {
        format!(
            "<DataArray type=\"{kind}\" Name=\"octruss:{name}\" format=\"ascii\">{values}</DataArray>\n"
        )
    };
    let arrays = [
        ("UInt32", "creases", ""),
        ("UInt32", "corners", ""),
        ("Int32", "feature_surfaces", ""),
        ("UInt32", "control_vertices", vertices),
        ("UInt8", "control_points", &bytes),
        ("UInt8", "control_placement", placement),
    ];
    let arrays: String = arrays.map(|(kind, name, values)| array(kind, name, values)).concat();
    let arrays = arrays
        .replace("Name=\"octruss:creases\"", "Name=\"octruss:creases\" NumberOfComponents=\"2\"");
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
    read(&path).map_err(|error| error.to_string())
}

fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|x| x.to_le_bytes()).collect()
}

#[test]
fn control_points_in_any_order_are_sorted() {
    let bytes = doubles(&[3.0, 3.5, 3.25, 1.0, 1.5, 1.25]);
    let found = tet_with("3 1", &bytes, "1 0").unwrap().mesh.features.unwrap().control_points;
    let expected = ControlPoints {
        vertices: vec![1, 3],
        positions: vec![[1.0, 1.5, 1.25], [3.0, 3.5, 3.25]],
        placement: Placement::AtLimit,
        curve_ends: CurveEnds::Fixed,
    };
    assert_eq!(found, Some(expected));
}

#[test]
fn broken_control_points_are_told() {
    let sound = doubles(&[1.0, 2.0, 3.0]);
    for (vertices, bytes, placement, array) in [
        ("1 2", &sound[..], "0 1", "octruss:control_points"),
        ("1", &sound[..23], "0 1", "octruss:control_points"),
        ("1", &doubles(&[1.0, f64::NAN, 3.0])[..], "0 1", "octruss:control_points"),
        ("1", &sound[..], "2 1", "octruss:control_placement"),
        ("1", &sound[..], "0 2", "octruss:control_placement"),
        ("1", &sound[..], "0", "octruss:control_placement"),
        ("1", &sound[..], "", "octruss:control_placement"),
    ] {
        let message = tet_with(vertices, bytes, placement).unwrap_err();
        assert!(message.contains(array) && message.contains("expected"), "{message}");
    }
}

#[test]
fn control_points_of_vertices_that_are_not_there_are_left_out() {
    let found = tet_with("4", &doubles(&[1.0, 2.0, 3.0]), "0 1").unwrap();
    assert!(found.mesh.features.is_none());
    assert_eq!(found.notes.len(), 1);
}
