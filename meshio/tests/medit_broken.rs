//! Broken Medit files: each gives one clear message, never a panic, a hang or a
//! large allocation.

use octruss_meshio::{Dataset, Error, parse};
use proptest::prelude::*;

const TET: &str = "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n\
0 0 1 0\nTetrahedra\n1\n1 2 3 4 7\nTriangles\n1\n1 2 3 5\nEnd\n";

const FOREIGN: &[u8] = include_bytes!("data/medit/cube-mmg.mesh");

fn read(bytes: &[u8]) -> Result<Dataset, Error> {
    parse("folder/broken.mesh".as_ref(), bytes)
}

/// The tet with the first occurrence of `old` replaced, which must be there.
fn edit(old: &str, new: &str) -> Vec<u8> {
    assert!(TET.contains(old), "{old}");
    TET.replacen(old, new, 1).into_bytes()
}

/// The tet up to `last` and with it.
fn cut(last: &str) -> Vec<u8> {
    TET.as_bytes()[..TET.find(last).expect("the cut") + last.len()].to_vec()
}

#[test]
fn broken_files_give_one_clear_message() {
    let huge = "4000000000000000000";
    #[rustfmt::skip]
    let cases: Vec<(&str, Vec<u8>, &[&str])> = vec![
        ("empty", vec![], &["the file is empty"]),
        ("blank", b"\n \n".to_vec(), &["the file is empty"]),
        ("Gmsh inside", b"$MeshFormat\n4.1 0 8\n".to_vec(), &["content is that of a .msh file"]),
        ("VTU inside", b"<?xml version=\"1.0\"?>".to_vec(), &["content is that of a .vtu file"]),
        ("garbage", b"\x7fELF\x02\n".to_vec(), &[":1: ", "not a Medit mesh", "ELF", "save the mesh as ASCII"]),
        ("comment alone", b"# nothing\n".to_vec(), &[":2: ", "ends where MeshVersionFormatted was expected"]),
        ("binary", vec![1, 0, 0, 0, 2, 0, 0, 0], &["binary Medit file", "save it as ASCII .mesh"]),
        ("binary, big endian", vec![0, 0, 0, 1, 0, 0, 0, 2], &["binary Medit file"]),
        ("version 5", edit("Formatted 2", "Formatted 5"), &["version 5", "save as version 1 to 4"]),
        ("version is text", edit("Formatted 2", "Formatted"), &[":2: ", "\"Dimension\" where the version was expected"]),
        ("two dimensions", edit("Dimension 3", "Dimension 2"), &["dimension 2; only meshes of tetrahedra"]),
        ("no word", edit("Triangles", "Tri-angles"), &[":12: ", "found \"Tri-angles\" where a keyword was expected"]),
        ("no dimension", edit("Dimension 3\n", ""), &[":2: ", "Vertices comes before Dimension"]),
        ("no vertices", cut("Dimension 3\n"), &[":3: ", "ends where the section Vertices was expected"]),
        ("cells before vertices", edit("Vertices", "Edges 1 1 2 3 Vertices"), &[":3: ", "Edges comes before Vertices"]),
        ("vertices twice", edit("Triangles", "Vertices"), &[":12: ", "a second section Vertices"]),
        ("hexahedra", edit("End", "Hexahedra 1 1 2 3 4 1 2 3 4 0 Hexahedra 2 1 2 3 4 1 2 3 4 0 1 2 3 4 1 2 3 4 0 Prisms\n2 1 2 3 4 1 2 0\n1 2 3 4 1 2 0"), &["the mesh has 3 Hexahedra, 2 Prisms; only Tetrahedra", "split other cells"]),
        ("third order", edit("End", "EdgesP3 1 1 2 3 4 0 End"), &["1 EdgesP3", "first or second order"]),
        ("order of nodes", edit("End", "TetrahedraP2Ordering 1 0 0 0 0"), &["(TetrahedraP2Ordering)", "linear elements"]),
        ("cut in a section", cut("0 1 0 0\n"), &[":4: ", "4 Vertices are announced, but only", "cut off"]),
        ("cut in a cell", cut("1 2 3 4"), &[":10: ", "1 Tetrahedra are announced, but only 8 bytes follow"]),
        ("cut in a long line", edit("1 2 3 5\nEnd\n", "0001 0002"), &[":14: ", "ends where a vertex of 1 Triangles", "it is cut off"]),
        ("cut before a count", cut("Tetrahedra\n"), &[":10: ", "ends where the number of Tetrahedra"]),
        ("absurd count", edit("\n4\n", &format!("\n{huge}\n")), &[":4: ", "4000000000000000000 Vertices are announced"]),
        ("absurd cells", edit("Tetrahedra\n1", &format!("Tetrahedra\n{huge}")), &[":10: ", "Tetrahedra are announced"]),
        ("absurd cells that are not read", edit("End", &format!("Hexahedra {huge} 1")), &["Hexahedra are announced"]),
        ("negative count", edit("\n4\n", "\n-4\n"), &[":4: ", "found \"-4\" where the number of Vertices", "0 or more"]),
        ("no count", edit("Triangles\n1\n", "Triangles\nx\n"), &[":13: ", "found \"x\" where the number of Triangles"]),
        ("more announced", edit("\n4\n", "\n5\n"), &[":9: ", "found \"Tetrahedra\" where a coordinate of 5 Vertices"]),
        ("fewer announced", edit("\n4\n", "\n3\n"), &[":8: ", "found \"0\" where a keyword was expected", "more than it announces"]),
        ("word among coordinates", edit("0 1 0 0", "0 one 0 0"), &[":7: ", "found \"one\"", "a number"]),
        ("no reference", edit("1 0 0 0\n", "1 0 0\n"), &[":9: ", "found \"Tetrahedra\"", "32 bits"]),
        ("large reference", edit("3 4 7", "3 4 4294967296"), &[":11: ", "a reference of 1 Tetrahedra", "32 bits"]),
        ("vertex 0", edit("1 2 3 4 7", "0 1 2 3 7"), &[":11: ", "the vertex 0; expected 1 to 4", "from 1"]),
        ("vertex beyond", edit("1 2 3 5", "1 2 5 5"), &[":14: ", "Triangles refers to the vertex 5; expected 1 to 4"]),
        ("vertex is no number", edit("1 2 3 4 7", "1 2.5 3 4 7"), &[":11: ", "found \"2.5\" where a vertex of 1 Tetrahedra"]),
    ];
    let mut faults = Vec::new();
    for (name, bytes, expected) in cases {
        let message = read(&bytes).map_or_else(|e| e.to_string(), |_| "was read".into());
        let one_line = !message.contains('\n') && message.len() < 400;
        let names_file = message.starts_with("folder/broken.mesh");
        if !one_line || !names_file || !expected.iter().all(|part| message.contains(part)) {
            faults.push(format!("{name}: {message}\n    expected {expected:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Reads the bytes; what comes back can be no larger than the bytes account for.
fn read_damaged(bytes: &[u8]) {
    let Ok(Dataset { mesh, .. }) = read(bytes) else { return };
    assert_eq!(mesh.tets.len(), mesh.regions.len());
    assert!(mesh.points.len() <= bytes.len() && mesh.tets.len() <= bytes.len());
    assert!(mesh.tets.as_flattened().iter().all(|&vertex| (vertex as usize) < mesh.points.len()));
}

#[test]
fn files_cut_at_any_byte_are_read_or_refused() {
    for end in 0..FOREIGN.len() {
        read_damaged(&FOREIGN[..end]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(4000) })]

    #[test]
    fn overwritten_bytes(
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut bytes = FOREIGN.to_vec();
        for (at, byte) in edits {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        read_damaged(&bytes);
    }

    #[test]
    fn digits_for_digits(
        edits in prop::collection::vec((any::<prop::sample::Index>(), "[-0-9 .\n#]{1,20}"), 1..4),
    ) {
        let mut bytes = FOREIGN.to_vec();
        for (at, text) in edits {
            let at = at.index(bytes.len());
            bytes.splice(at..at + 1, text.into_bytes());
        }
        read_damaged(&bytes);
    }
}
