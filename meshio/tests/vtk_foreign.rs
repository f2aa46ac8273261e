//! Files as other programs write them: mixed cells, other tags, several pieces.

use octruss_meshio::{Dataset, Error, Field, Values, read};

/// A piece of a VTU file; lists as they stand in the file.
struct Piece {
    points: usize,
    cells: usize,
    coordinates: &'static str,
    connectivity: &'static str,
    ends: &'static str,
    types: &'static str,
    /// More arrays of the cells: type, name, values.
    cell_data: &'static [(&'static str, &'static str, &'static str)],
}

const TET: Piece = Piece {
    points: 4,
    cells: 1,
    coordinates: "0 0 0  1 0 0  0 1 0  0 0 1",
    connectivity: "0 1 2 3",
    ends: "4",
    types: "10",
    cell_data: &[],
};

fn array(kind: &str, name: &str, components: usize, values: &str) -> String {
    format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" \
         format=\"ascii\">{values}</DataArray>\n"
    )
}

fn vtu(pieces: &[Piece]) -> Result<Dataset, Error> {
    let mut text = String::from("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>");
    for piece in pieces {
        let (points, cells) = (piece.points, piece.cells);
        let first: Vec<String> = (0..points).map(|point| (10 * point).to_string()).collect();
        text += &format!("<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">");
        text += &format!(
            "<PointData>{}</PointData><CellData>",
            array("Int8", "p", 1, &first.join(" "))
        );
        for (kind, name, values) in piece.cell_data {
            text += &array(kind, name, 1, values);
        }
        text += &format!(
            "</CellData><Points>{}</Points><Cells>",
            array("Float64", "", 3, piece.coordinates)
        );
        text += &array("Int32", "connectivity", 1, piece.connectivity);
        text += &array("Int32", "offsets", 1, piece.ends);
        text += &array("UInt8", "types", 1, piece.types);
        text += "</Cells></Piece>";
    }
    text += "</UnstructuredGrid></VTKFile>";
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("foreign.vtu");
    std::fs::write(&path, text).unwrap();
    read(&path)
}

#[test]
fn simplices_of_lower_dimension_become_tagged_by_the_tags_of_cells() {
    let mixed = Piece {
        cells: 6,
        connectivity: "0 1 2  0 1 2 3  0 1  2  1 2 3  0 2",
        ends: "3 7 9 10 13 15",
        types: "5 10 3 1 5 3",
        cell_data: &[("Int32", "MaterialIds", "4 7 5 6 0 0"), ("Float64", "e", "0 0.5 0 0 0 0")],
        ..TET
    };
    let dataset = vtu(&[mixed]).unwrap();
    assert_eq!(dataset.mesh.tets, [[0, 1, 2, 3]]);
    assert_eq!(dataset.mesh.regions, [7]);
    assert_eq!(dataset.mesh.triangles.iter().collect::<Vec<_>>(), [([0, 1, 2], 4)]);
    assert_eq!(dataset.mesh.edges.iter().collect::<Vec<_>>(), [([0, 1], 5)]);
    assert_eq!(dataset.mesh.vertices.iter().collect::<Vec<_>>(), [([2], 6)]);
    assert_eq!(dataset.cell_fields, [Field::scalar("e", vec![0.5])]);
    assert_eq!(dataset.notes.len(), 1);
    assert!(dataset.notes[0].starts_with("2 triangles, lines or vertices without a tag"));
}

#[test]
fn the_first_known_array_of_whole_numbers_holds_the_tags() {
    for (cell_data, region, fields) in [
        (
            &[("Int8", "MaterialIds", "3"), ("Int64", "gmsh:physical", "-4")][..],
            -4,
            vec!["MaterialIds"],
        ),
        (
            &[("UInt16", "CellEntityIds", "5"), ("Int32", "medit:ref", "6")],
            6,
            vec!["CellEntityIds"],
        ),
        (&[("Float32", "region", "2"), ("Int32", "medit:ref", "6")], 2, vec!["medit:ref"]),
        (&[("Float32", "region", "2.5"), ("Int32", "medit:ref", "6")], 6, vec!["region"]),
        (&[("Int32", "other", "9")], 0, vec!["other"]),
    ] {
        let dataset = vtu(&[Piece { cell_data, ..TET }]).unwrap();
        assert_eq!(dataset.mesh.regions, [region], "{cell_data:?}");
        let names: Vec<&str> = dataset.cell_fields.iter().map(|f| f.name.as_str()).collect();
        assert_eq!(names, fields);
    }
}

#[test]
fn quadratic_cells_are_read_as_their_corners() {
    // The nodes 4 to 9 lie on edges, but the line makes 9 a corner as well.
    let quadratic = Piece {
        points: 10,
        cells: 3,
        coordinates: "0 0 0  2 0 0  0 2 0  0 0 2  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  0 1 1",
        connectivity: "0 1 2 3 4 5 6 7 8 9  0 1 2 4 5 6  3 9",
        ends: "10 16 18",
        types: "24 22 3",
        cell_data: &[("Int32", "region", "1 2 3")],
    };
    let dataset = vtu(&[quadratic]).unwrap();
    assert_eq!(dataset.mesh.points.len(), 5);
    assert_eq!(dataset.mesh.points[4], [0.0, 1.0, 1.0]);
    assert_eq!(dataset.mesh.tets, [[0, 1, 2, 3]]);
    assert_eq!(dataset.mesh.triangles.simplices, [[0, 1, 2]]);
    assert_eq!(dataset.mesh.edges.simplices, [[3, 4]]);
    assert_eq!(dataset.point_fields[0].values, Values::Integer(vec![0, 10, 20, 30, 90]));
    let note = "Second-order cells, 1 tets among them, were read as linear ones; \
                5 mid-side nodes were dropped.";
    assert_eq!(dataset.notes, [note]);
}

#[test]
fn pieces_are_joined() {
    let tagged = |values| Piece { cell_data: values, ..TET };
    let empty = Piece {
        points: 0,
        cells: 0,
        coordinates: "",
        connectivity: "",
        ends: "",
        types: "",
        cell_data: &[("Int32", "region", "")],
    };
    let pieces = [tagged(&[("Int32", "region", "1")]), empty, tagged(&[("Int32", "region", "2")])];
    let dataset = vtu(&pieces).unwrap();
    assert_eq!(dataset.mesh.tets, [[0, 1, 2, 3], [4, 5, 6, 7]]);
    assert_eq!(dataset.mesh.regions, [1, 2]);
    assert_eq!(dataset.mesh.points.len(), 8);
    assert_eq!(dataset.point_fields[0].values, Values::Integer([0, 10, 20, 30].repeat(2)));
}

#[test]
fn pieces_that_do_not_fit_together_are_refused() {
    for (pieces, expected) in [
        (
            [TET, Piece { cell_data: &[("Int32", "x", "1")], ..TET }],
            "other arrays than those of piece 0",
        ),
        ([Piece { connectivity: "0 1 2 4", ..TET }, TET], "piece 0: a vertex number exceeds"),
    ] {
        let message = vtu(&pieces).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    }
}
