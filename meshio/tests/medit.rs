//! Medit files as other programs write them.

use std::path::Path;

use octruss_mesh::RawMesh;
use octruss_meshio::{Dataset, parse, read};

fn read_text(text: &str) -> Dataset {
    parse("small.mesh".as_ref(), text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

/// The volume of the tets of one region.
fn volume(mesh: &RawMesh, region: i32) -> f64 {
    let tets = mesh.tets.iter().zip(&mesh.regions).filter(|pair| *pair.1 == region);
    tets.map(|(tet, _)| {
        let [a, b, c, d] = tet.map(|vertex| mesh.points[vertex as usize]);
        let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        let minor = |i: usize, j: usize| v[i] * w[j] - v[j] * w[i];
        (u[0] * minor(1, 2) + u[1] * minor(2, 0) + u[2] * minor(0, 1)) / 6.0
    })
    .sum()
}

#[test]
fn a_file_of_mmg_with_all_its_sections() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/medit");
    let Dataset { mesh, notes, .. } = read(&folder.join("cube-mmg.mesh")).unwrap();
    assert_eq!((mesh.points.len(), mesh.points[3]), (8, [2.0, 2.0, 0.0]));
    assert_eq!(mesh.regions, [1, 2, 2, 2, -4]);
    // A third of the cube's 8 is inside; each corner that is cut off has a sixth.
    for (region, expected) in [(1, 8.0 / 3.0), (2, 4.0), (-4, 4.0 / 3.0)] {
        let volume = volume(&mesh, region);
        assert!((volume - expected).abs() < 1e-14, "region {region}: {volume}");
    }
    let triangles: Vec<_> = mesh.triangles.iter().collect();
    assert_eq!(triangles, [([0, 3, 1], 5), ([0, 2, 3], 5)]);
    let edges: Vec<_> = mesh.edges.iter().collect();
    assert_eq!(edges, [([0, 1], 7), ([3, 1], -8)]);
    assert!(mesh.vertices.is_empty() && mesh.groups.is_empty());
    assert_eq!(
        notes,
        [
            "The references of 3 vertices were left out.",
            "3 triangles, lines or vertices without a tag were left out.",
            "The sections Corners, NormalAtVertices, Normals, RequiredEdges, RequiredVertices, \
             Ridges, TangentAtVertices, Tangents were left out.",
        ]
    );
}

#[test]
fn words_count_and_lines_do_not() {
    let lines = "MeshVersionFormatted 1\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n\
        0 0 1 0\nTetrahedra\n1\n1 2 3 4 9\nEnd\n";
    let expected = read_text(lines);
    assert_eq!(expected.mesh.tets, [[0, 1, 2, 3]]);
    assert_eq!(expected.mesh.regions, [9]);
    assert!(expected.notes.is_empty(), "{:?}", expected.notes);
    let one_line = lines.replace('\n', " ");
    let windows = lines.replace('\n', "\r\n");
    let small_letters = lines.to_lowercase();
    let commented = lines.replace('\n', " # Tetrahedra 7\n");
    let spread = lines.replace(' ', "\n\n\t");
    let with_more_behind = format!("{lines}\nVertices 3 1 2");
    let empty_sections = lines.replace("End", "Hexahedra 0\nQuadrilaterals\n0\nRidges 0\nEnd");
    for text in
        [one_line, windows, small_letters, commented, spread, with_more_behind, empty_sections]
    {
        assert_eq!(read_text(&text), expected, "{text}");
    }
}

#[test]
fn second_order_cells_are_read_as_their_corners() {
    // The vertices 5 to 10 lie on edges, but the edge makes 10 a corner as well.
    let text = "MeshVersionFormatted 3 Dimension 3 Vertices 10\n\
        0 0 0 0  2 0 0 0  0 2 0 0  0 0 2 0  1 0 0 0  1 1 0 0  0 1 0 0  0 0 1 0  1 0 1 0  0 1 1 0\n\
        TetrahedraP2 1  1 2 3 4 5 6 7 8 9 10  1  TrianglesP2 1  1 2 3 5 6 7  2\n\
        EdgesP2 1  1 2 5  3  Edges 1  4 10  4  End";
    let Dataset { mesh, notes, .. } = read_text(text);
    assert_eq!(mesh.points.len(), 5);
    assert_eq!(mesh.points[4], [0.0, 1.0, 1.0]);
    assert_eq!(mesh.tets, [[0, 1, 2, 3]]);
    assert_eq!(mesh.triangles.simplices, [[0, 1, 2]]);
    let edges: Vec<_> = mesh.edges.iter().collect();
    assert_eq!(edges, [([0, 1], 3), ([3, 4], 4)]);
    let note = "Second-order cells, 1 tets among them, were read as linear ones; \
                5 mid-side nodes were dropped.";
    assert_eq!(notes, [note]);
}

#[test]
fn a_file_without_its_last_word_is_read_with_a_note() {
    let text = "MeshVersionFormatted 2\nDimension\n3\nVertices\n1\n0.5 nan 1e400 0\n";
    let Dataset { mesh, notes, .. } = read_text(text);
    let [x, y, z] = mesh.points[0];
    assert!(x == 0.5 && y.is_nan() && z == f64::INFINITY);
    assert!(notes.len() == 1 && notes[0].starts_with("The file does not close with End"));
}
