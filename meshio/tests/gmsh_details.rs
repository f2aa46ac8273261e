//! Details of the format, on meshes small enough to be written out here.

use octruss_meshio::{Dataset, Field, Values, parse};

fn read(bytes: &[u8]) -> Dataset {
    parse("small.msh".as_ref(), bytes).unwrap_or_else(|error| panic!("{error}"))
}

/// A 2.2 file with five nodes and these lines of elements.
fn with_elements(elements: &[&str]) -> String {
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
         $Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n\
         $Elements\n{}\n{}\n$EndElements\n",
        elements.len(),
        elements.join("\n")
    )
}

/// One tet of group 7 as MSH 4.1, binary, numbers by these functions.
fn binary_tet(
    int: fn(i32) -> [u8; 4],
    size: fn(u64) -> [u8; 8],
    double: fn(f64) -> [u8; 8],
) -> Vec<u8> {
    let ints = |values: &[i32]| values.iter().flat_map(|&value| int(value)).collect::<Vec<u8>>();
    let sizes = |values: &[u64]| values.iter().flat_map(|&value| size(value)).collect::<Vec<u8>>();
    let doubles = |values: &[f64]| values.iter().flat_map(|&v| double(v)).collect::<Vec<u8>>();
    [
        b"$MeshFormat\n4.1 1 8\n".to_vec(),
        ints(&[1]),
        b"\n$EndMeshFormat\n$Entities\n".to_vec(),
        sizes(&[0, 0, 0, 1]),
        ints(&[1]),
        doubles(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0]),
        sizes(&[1]),
        ints(&[7]),
        sizes(&[0]),
        b"\n$EndEntities\n$Nodes\n".to_vec(),
        sizes(&[1, 4, 1, 4]),
        ints(&[3, 1, 0]),
        sizes(&[4, 1, 2, 3, 4]),
        doubles(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.5]),
        b"\n$EndNodes\n$Elements\n".to_vec(),
        sizes(&[1, 1, 1, 1]),
        ints(&[3, 1, 4]),
        sizes(&[1, 1, 1, 2, 3, 4]),
        b"\n$EndElements\n".to_vec(),
    ]
    .concat()
}

#[test]
fn either_byte_order() {
    let little = read(&binary_tet(i32::to_le_bytes, u64::to_le_bytes, f64::to_le_bytes));
    let big = read(&binary_tet(i32::to_be_bytes, u64::to_be_bytes, f64::to_be_bytes));
    assert_eq!(little.mesh.tets, [[0, 1, 2, 3]]);
    assert_eq!(little.mesh.regions, [7]);
    assert_eq!(little.mesh.points[3], [0.0, 0.0, 1.5]);
    assert_eq!(big, little);
}

#[test]
fn elements_without_a_group() {
    // Group 0, and no tags at all.
    let mesh = read(
        with_elements(&["1 4 2 0 1 1 2 3 4", "2 4 0 2 3 4 5", "3 2 2 0 1 1 2 3", "4 15 0 5"])
            .as_bytes(),
    )
    .mesh;
    assert_eq!(mesh.tets, [[0, 1, 2, 3], [1, 2, 3, 4]]);
    assert_eq!(mesh.regions, [0, 0]);
    assert!(mesh.triangles.is_empty() && mesh.vertices.is_empty());
    assert_eq!(mesh.points.len(), 5);
}

#[test]
fn named_groups_that_no_element_is_in_are_noted() {
    let names = "$PhysicalNames\n1\n3 7 \"solid\"\n$EndPhysicalNames\n";
    let named =
        |element: &str| with_elements(&[element]).replace("$Nodes", &format!("{names}$Nodes"));
    let notes = read(named("1 4 2 0 1 1 2 3 4").as_bytes()).notes;
    assert!(notes.len() == 1 && notes[0].contains("Mesh.SaveAll"), "{notes:?}");
    assert!(read(named("1 4 2 7 1 1 2 3 4").as_bytes()).notes.is_empty());
}

#[test]
fn a_tet_twice_in_one_group_stays_a_duplicate() {
    let file = with_elements(&[
        "1 4 2 7 1 1 2 3 4",
        "2 4 2 8 1 1 2 3 4",
        "3 4 2 8 1 1 2 3 4",
        "4 4 2 8 1 2 3 4 5",
    ]);
    let Dataset { mesh, notes, .. } = read(file.as_bytes());
    assert_eq!(mesh.tets, [[0, 1, 2, 3], [0, 1, 2, 3], [1, 2, 3, 4]]);
    assert_eq!(mesh.regions, [7, 8, 8]);
    assert!(notes.len() == 1 && notes[0].starts_with("1 tets are in several"), "{notes:?}");
}

#[test]
fn a_mid_side_node_that_is_a_corner_elsewhere_is_kept() {
    // Node 2 is the middle of the second-order line 1–3 and a corner of the tet;
    // node 5, in the file the first, is the middle of the line 2–3 only.
    let data =
        "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n5\n5 50\n4 40\n3 30\n2 20\n1 10\n$EndNodeData\n";
    let file = with_elements(&["1 4 2 7 1 1 2 3 4", "2 8 2 5 1 1 3 2", "3 8 2 5 1 2 3 5"]) + data;
    let file = file.replace("5 1 1 1\n", "").replace("1 0 0 0\n", "5 1 1 1\n1 0 0 0\n");
    let Dataset { mesh, point_fields, .. } = read(file.as_bytes());
    assert_eq!(mesh.points, [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(mesh.tets, [[0, 1, 2, 3]]);
    assert_eq!(mesh.edges.simplices, [[0, 2], [1, 2]]);
    assert_eq!(point_fields, [Field::scalar("T", vec![10.0, 20.0, 30.0, 40.0])]);
}

#[test]
fn coordinates_that_are_not_finite_are_left_for_the_check() {
    let file = with_elements(&["1 4 2 7 1 1 2 3 4"]).replace("5 1 1 1", "5 nan inf -1e400");
    let point = read(file.as_bytes()).mesh.points[4];
    assert!(point[0].is_nan());
    assert_eq!(point[1..], [f64::INFINITY, f64::NEG_INFINITY]);
}

#[test]
fn comments_hold_anything_and_unknown_sections_are_noted() {
    let comment = "$Comments\n$Nodes\n-3\n$EndNodes\n$EndComments\n";
    let unknown = "$Custom\n1 2 3\n$EndCustom\n";
    let file = with_elements(&["1 4 2 7 1 1 2 3 4"]);
    let file = format!("{comment}{file}{comment}{unknown}\n");
    let Dataset { mesh, notes, .. } = read(file.as_bytes());
    assert_eq!((mesh.points.len(), mesh.tets.len()), (5, 1));
    assert_eq!(notes, ["The section $Custom was passed over."]);
}

#[test]
fn line_ends_of_windows() {
    let file = with_elements(&["1 4 2 7 1 1 2 3 4", "2 2 2 5 1 1 2 3"]);
    assert_eq!(read(file.replace('\n', "\r\n").as_bytes()), read(file.as_bytes()));
}

#[test]
fn time_steps_of_a_name_are_told_apart() {
    let step = |step: u8| {
        format!(
            "$NodeData\n1\n\"T\"\n1\n0\n3\n{step}\n1\n5\n1 1\n2 2\n3 3\n4 4\n5 {step}\n$EndNodeData\n"
        )
    };
    let file = with_elements(&["1 4 2 7 1 1 2 3 4"]) + &step(0) + &step(1) + &step(1);
    let dataset = read(file.as_bytes());
    let names: Vec<&str> = dataset.point_fields.iter().map(|field| field.name.as_str()).collect();
    assert_eq!(names, ["T", "T (step 1)", "T (step 1)'"]);
}

/// Two tets and a triangle, with values of one and of three components at their nodes.
#[test]
fn element_node_data_become_fields_at_corners() {
    let mesh = with_elements(&["7 2 2 1 1 1 2 3", "8 4 2 1 1 1 2 3 4", "9 4 2 2 1 2 3 4 5"]);
    let data = "$ElementNodeData\n1\n\"rho\"\n1\n0\n3\n0\n1\n3\n7 3 1 2 3\n9 4 5 6 7 8\n\
        8 4 1 2 3 4\n$EndElementNodeData\n$ElementNodeData\n1\n\"q\"\n1\n0\n3\n0\n3\n1\n\
        8 6 1 2 3 4 5 6 7 8 9 10 11 12 0 0 0 0 0 0\n$EndElementNodeData\n";
    let Dataset { corner_fields, notes, .. } = read(format!("{mesh}{data}").as_bytes());
    let [rho, q] = &corner_fields[..] else { panic!("two fields") };
    assert_eq!(*rho, Field::scalar("rho", vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]));
    assert_eq!((q.name.as_str(), q.components), ("q", 3));
    let Values::Float(values) = &q.values else { panic!("floating-point values") };
    assert_eq!(values[..12], [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0]);
    assert!(values.len() == 24 && values[12..].iter().all(|value| value.is_nan()));
    assert_eq!(notes, ["The field \"q\" has no value for 1 of 2 tets; it is NaN there."]);

    let few = data.replace("9 4 5 6 7 8", "9 3 5 6 7");
    let refused = parse("small.msh".as_ref(), format!("{mesh}{few}").as_bytes());
    let error = refused.unwrap_err().to_string();
    // 17 lines of mesh, 9 before the values, and that of the triangle.
    assert!(error.contains(":28: values at 3 nodes of a tet; expected at least its 4"), "{error}");
}
