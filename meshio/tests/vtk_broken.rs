//! Broken VTK files: each gives one clear message, never a panic, a hang or a
//! large allocation.

use std::path::Path;

use octruss_mesh::shapes;
use octruss_meshio::vtu::{Compression, VtuOptions};
use octruss_meshio::{Dataset, Error, legacy, read, vtu};
use proptest::prelude::*;

/// One tet as ASCII VTU, which the cases below break in one place each.
const ASCII: &str = r#"<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt32">
<UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="1">
<PointData><DataArray type="UInt64" Name="u" format="ascii">1 2 3 4</DataArray></PointData>
<CellData><DataArray type="Int32" Name="region" format="ascii">7</DataArray></CellData>
<Points>
<DataArray type="Float32" Name="Points" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray>
</Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
"#;

/// 2⁶¹ components: as doubles, a tuple has 2⁶⁴ bytes, which wraps round to none.
const NO_POINTS: &str = r#"<VTKFile type="UnstructuredGrid"><UnstructuredGrid>
<Piece NumberOfPoints="0" NumberOfCells="0"><PointData>
<DataArray type="Float64" Name="u" NumberOfComponents="2305843009213693952" format="ascii"></DataArray>
</PointData></Piece></UnstructuredGrid></VTKFile>
"#;

const LEGACY: &str = "# vtk DataFile Version 3.0\none tet\nASCII\nDATASET UNSTRUCTURED_GRID\n\
POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n\
CELL_DATA 1\nSCALARS region int 1\nLOOKUP_TABLE default\n7\n";

/// Six thousand tets with fields as our own writer leaves them.
fn raw(compression: Compression) -> Vec<u8> {
    let mesh = shapes::kuhn_cube(4).into_raw();
    let dataset = Dataset { mesh, ..Dataset::default() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("good.vtu");
    vtu::write_with(&path, &dataset, &VtuOptions { compression }).unwrap();
    std::fs::read(path).unwrap()
}

fn binary_legacy() -> Vec<u8> {
    let mesh = shapes::kuhn_cube(2).into_raw();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("good.vtk");
    legacy::write(&path, &Dataset { mesh, ..Dataset::default() }).unwrap();
    std::fs::read(path).unwrap()
}

/// `text` with one piece of it replaced, which must be there.
fn changed(text: &str, old: &str, new: &str) -> Vec<u8> {
    assert!(text.contains(old), "{old}");
    text.replacen(old, new, 1).into_bytes()
}

fn ascii(old: &str, new: &str) -> Vec<u8> {
    changed(ASCII, old, new)
}

/// The tet twice over, with these offsets.
fn two_cells(offsets: &str) -> Vec<u8> {
    ASCII
        .replacen("NumberOfCells=\"1\"", "NumberOfCells=\"2\"", 1)
        .replacen(">7</", ">7 7</", 1)
        .replacen(">4</", &format!(">{offsets}</"), 1)
        .replacen(">10</", ">10 10</", 1)
        .into()
}

/// The tet with its connectivity as base64 text.
fn base64(text: &str) -> Vec<u8> {
    let old = r#"Name="connectivity" format="ascii">0 1 2 3"#;
    ascii(old, &format!(r#"Name="connectivity" format="binary">{text}"#))
}

/// The tet with its connectivity in an appended section of these bytes.
fn appended(attributes: &str, offset: &str, bytes: &[u8]) -> Vec<u8> {
    let old = r#"format="ascii">0 1 2 3</DataArray>"#;
    let text = ASCII.replacen(old, &format!(r#"format="appended" offset="{offset}"/>"#), 1);
    let text = text.replacen(" header_type=\"UInt32\"", attributes, 1);
    let mut file = text.trim_end().strip_suffix("</VTKFile>").unwrap().as_bytes().to_vec();
    file.extend_from_slice(b"<AppendedData encoding=\"raw\">_");
    file.extend_from_slice(bytes);
    file
}

fn words(words: &[u64]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

fn cut(bytes: Vec<u8>, kept: f64) -> Vec<u8> {
    let length = (bytes.len() as f64 * kept) as usize;
    bytes[..length].to_vec()
}

fn read_bytes(extension: &str, bytes: &[u8]) -> Result<Dataset, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken").with_extension(extension);
    std::fs::write(&path, bytes).unwrap();
    read(&path)
}

#[test]
fn the_cases_are_sound_before_they_are_broken() {
    for (extension, text) in [("vtu", ASCII), ("vtk", LEGACY)] {
        let dataset = read_bytes(extension, text.as_bytes()).unwrap();
        assert_eq!(dataset.mesh.tets, [[0, 1, 2, 3]]);
        assert_eq!(dataset.mesh.regions, [7]);
        assert_eq!(dataset.notes, [] as [&str; 0]);
    }
    let mut connectivity = words(&[32, 0, 1, 2, 3]);
    connectivity.extend_from_slice(b"</AppendedData></VTKFile>");
    let good = appended(r#" header_type="UInt64""#, "0", &connectivity);
    assert_eq!(read_bytes("vtu", &good).unwrap().mesh.tets, [[0, 1, 2, 3]]);
    let good = base64("IAAAAAAAAAAAAAAAAQAAAAAAAAACAAAAAAAAAAMAAAAAAAAA");
    assert_eq!(read_bytes("vtu", &good).unwrap().mesh.tets, [[0, 1, 2, 3]]);
}

#[test]
fn broken_files_give_one_clear_message() {
    let wide = r#" header_type="UInt64""#;
    let zlib = r#" header_type="UInt64" compressor="vtkZLibDataCompressor""#;
    let huge = 1_000_000_000_000_000_000;
    #[rustfmt::skip]
    let cases: Vec<(&str, &str, Vec<u8>, &[&str])> = vec![
        // Files that are something else.
        ("empty", "vtu", vec![], &["the file is empty"]),
        ("blank", "vtk", b" \n\n".to_vec(), &["the file is empty"]),
        ("garbage", "vtu", vec![0xff, 0xfe, 7, 0, 1], &["at byte 0", "not text"]),
        ("garbage text", "vtu", b"solid ascii".to_vec(), &["no VTU file"]),
        ("garbage", "vtk", vec![7; 99], &["at byte 0", "cannot be understood"]),
        ("Gmsh inside", "vtu", b"$MeshFormat\n4.1 0 8\n".to_vec(), &["content is that of a .msh file"]),
        ("Gmsh inside", "vtk", b"$MeshFormat\n4.1 0 8\n".to_vec(), &["content is that of a .msh file"]),
        ("legacy inside", "vtu", LEGACY.into(), &["content is that of a .vtk file"]),
        ("Medit inside", "vtu", b"MeshVersionFormatted 2\n".to_vec(), &["content is that of a .mesh file"]),
        ("VTU inside", "vtk", ASCII.into(), &["content is that of a .vtu file"]),
        ("PVD inside", "vtu", ascii("\"UnstructuredGrid\"", "\"Collection\""), &["holds Collection", "only UnstructuredGrid"]),
        ("other XML", "vtu", b"<svg></svg>".to_vec(), &[":1", "<svg>", "no VTU file"]),
        // XML.
        ("cut in the XML", "vtu", ascii("</Piece></UnstructuredGrid></VTKFile>", ""), &["ends before all its elements are closed"]),
        ("cut in a tag", "vtu", cut(ASCII.into(), 0.7), &["broken.vtu:9", "XML is broken"]),
        ("wrong nesting", "vtu", ascii("</Piece></UnstructuredGrid>", "</UnstructuredGrid></Piece>"), &[":12", "XML is broken"]),
        ("piece outside", "vtu", ascii("<UnstructuredGrid>", "<UnstructuredGrid></UnstructuredGrid><Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"></Piece><UnstructuredGrid>"), &[":3", "<Piece> inside File"]),
        ("no grid", "vtu", b"<VTKFile type=\"UnstructuredGrid\"></VTKFile>".to_vec(), &["no <UnstructuredGrid>"]),
        ("no count", "vtu", ascii("NumberOfCells=\"1\"", ""), &[":3", "<Piece> lacks the attribute NumberOfCells"]),
        ("negative count", "vtu", ascii("NumberOfPoints=\"4\"", "NumberOfPoints=\"-4\""), &["NumberOfPoints=\"-4\"", "not a count"]),
        ("unknown type", "vtu", ascii("\"Int32\" Name", "\"Int12\" Name"), &["array `region`", "unknown type \"Int12\""]),
        ("unknown encoding", "vtu", ascii("format=\"ascii\"", "format=\"morse\""), &["array `u`", "format=\"morse\"", "expected ascii"]),
        ("unknown compressor", "vtu", appended(" compressor=\"vtkLZMADataCompressor\"", "0", &[]), &["vtkLZMADataCompressor", "save the file without compression"]),
        ("unknown header type", "vtu", ascii("\"UInt32\"", "\"UInt16\""), &["header_type=\"UInt16\""]),
        // Counts and arrays that contradict each other.
        ("absurd points", "vtu", ascii("NumberOfPoints=\"4\"", &format!("NumberOfPoints=\"{huge}\"")), &["array `Points`", "holds 12 numbers", "1000000000000000000 points"]),
        ("absurd cells", "vtu", ascii("NumberOfCells=\"1\"", &format!("NumberOfCells=\"{huge}\"")), &["array `types`", "holds 1 numbers", "cells (NumberOfCells)"]),
        ("more cells", "vtu", ascii("NumberOfCells=\"1\"", "NumberOfCells=\"2\""), &["expected 1 for each of 2 cells"]),
        ("absurd components", "vtu", ascii("Name=\"u\"", "Name=\"u\" NumberOfComponents=\"18446744073709551615\""), &["array `u`", "NumberOfComponents is 18446744073709551615, not from 1"]),
        ("no components", "vtu", ascii("Name=\"u\"", "Name=\"u\" NumberOfComponents=\"0\""), &["array `u`", "NumberOfComponents is 0, not from 1"]),
        ("components without points", "vtu", NO_POINTS.into(), &["array `u`", "NumberOfComponents is 2305843009213693952, not from 1"]),
        ("missing arrays", "vtu", ascii("Name=\"offsets\"", "Name=\"onsets\""), &["<Cells>", "`connectivity`, `offsets` and `types`"]),
        ("no coordinates", "vtu", ascii("<DataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray>", ""), &["<Points>", "coordinates are missing"]),
        ("offset too small", "vtu", ascii(">4</DataArray>", ">3</DataArray>"), &["array `offsets`", "from 0 to 3", "has 4 vertices"]),
        ("offsets not ascending", "vtu", two_cells("4 0"), &["array `offsets`", "cell 1 reaches from 4 to 0"]),
        ("offset beyond", "vtu", ascii(">0 1 2 3<", ">0 1 2<"), &["array `connectivity`", "holds 3 vertex numbers, the cells need 4"]),
        ("negative vertex", "vtu", ascii(">0 1 2 3<", ">0 1 2 -3<"), &["array `connectivity`", "`-3` is not a vertex number"]),
        ("large vertex", "vtu", ascii(">0 1 2 3<", ">0 1 2 4294967296<"), &["`4294967296` is not a vertex number"]),
        ("NaN vertex", "vtu", ascii(">0 1 2 3<", ">0 1 2 nan<"), &["array `connectivity`", "`nan` is not a vertex number"]),
        ("word among coordinates", "vtu", ascii(">0 0 0 1", ">0 0 zero 1"), &["array `Points`", "`zero` is not a number"]),
        ("large value", "vtu", ascii("1 2 3 4", "1 2 3 9223372036854775808"), &["array `u`", "9223372036854775808", "64 bits with sign"]),
        ("large region", "vtu", ascii(">7<", ">4294967296<"), &["array `region`", "does not fit 32 bits"]),
        ("hexahedron", "vtu", ascii(">10</DataArray>", ">12</DataArray>"), &["1 hexahedron (VTK type 12)", "tetrahedra first"]),
        // Binary data.
        ("bad base64", "vtu", base64("IAAA*AAA"), &["array `connectivity`", "not valid base64"]),
        ("padding alone", "vtu", base64("="), &["array `connectivity`", "not valid base64"]),
        ("short base64", "vtu", base64("IAAAAAAA"), &["array `connectivity`", "32 bytes announced, 2 left"]),
        ("split number", "vtu", base64("AwAAAAAAAA=="), &["array `connectivity`", "3 bytes are no whole number of Int64"]),
        ("no section", "vtu", ascii("format=\"ascii\">0 1 2 3</DataArray>", "format=\"appended\" offset=\"0\"/>"), &["array `connectivity`", "no <AppendedData>"]),
        ("offset beyond the file", "vtu", appended(wide, "99999999999", &words(&[0])), &["array `connectivity`", "offset 99999999999 lies beyond the 8 bytes"]),
        ("truncated block", "vtu", appended(wide, "0", &words(&[32, 0, 1])), &["array `connectivity`", "32 bytes announced, 16 left"]),
        ("absurd length", "vtu", appended(wide, "0", &words(&[u64::MAX, 0, 1])), &["array `connectivity`", "bytes announced, 16 left"]),
        ("cut in the data", "vtu", cut(raw(Compression::None), 0.9), &["array `types`", "beyond", "cut off"]),
        ("cut in zlib data", "vtu", cut(raw(Compression::Zlib(1)), 0.97), &["array `types`", "beyond", "cut off"]),
        ("absurd blocks", "vtu", appended(zlib, "0", &words(&[huge, 8, 8, 8])), &["array `connectivity`", "announces 1000000000000000000 blocks"]),
        ("zip bomb", "vtu", appended(zlib, "0", &words(&[1, huge, 0, 8, 0])), &["array `connectivity`", "more than zlib can pack"]),
        ("damaged zlib", "vtu", appended(zlib, "0", &words(&[1, 32, 0, 8, 0x0102_0304_0506_0708])), &["array `connectivity`", "damaged zlib block 0"]),
        // Legacy.
        ("truncated", "vtk", cut(LEGACY.into(), 0.5), &["at byte"]),
        ("truncated binary", "vtk", cut(binary_legacy(), 0.6), &["at byte"]),
        ("absurd points", "vtk", changed(LEGACY, "POINTS 4", "POINTS 4000000000"), &["at byte", "cannot be understood"]),
        ("NaN text", "vtk", changed(LEGACY, "1 0 0 0 1 0", "1 0 0 nan 1 0"), &["at byte", "nan 1 0"]),
        ("surfaces only", "vtk", changed(LEGACY, "UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n", "POLYDATA\nPOINTS 1 float\n0 0 0\n"), &["POLYDATA", "only UNSTRUCTURED_GRID"]),
        ("array of an unknown type", "vtk", changed(LEGACY, "region int", "region quaternion"), &["at byte"]),
        ("array after the last", "vtk", format!("{LEGACY}FIELD more 1\nu 1 1 string\nx\n").into(), &["at byte"]),
        ("hexahedron", "vtk", changed(LEGACY, "CELL_TYPES 1\n10", "CELL_TYPES 1\n12"), &["1 hexahedron (VTK type 12)"]),
        ("negative vertex", "vtk", changed(LEGACY, "4 0 1 2 3", "4 0 1 2 -3"), &["at byte"]),
        ("types missing", "vtk", changed(LEGACY, "CELL_TYPES 1\n10\n", ""), &["at byte"]),
        ("fields of another length", "vtk", changed(LEGACY, "CELL_DATA 1", "POINT_DATA 1"), &["array `region`", "expected 1 for each of 4 points"]),
    ];
    let mut faults = Vec::new();
    for (name, extension, bytes, expected) in cases {
        let message =
            read_bytes(extension, &bytes).map_or_else(|e| e.to_string(), |_| "was read".into());
        let one_line = !message.contains('\n') && message.len() < 400;
        let names_file = message.contains(&format!("broken.{extension}"));
        if !one_line || !names_file || !expected.iter().all(|part| message.contains(part)) {
            faults.push(format!("{name}.{extension}: {message}\n    expected {expected:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn other_extensions_are_refused_with_a_list() {
    for path in ["part.stl", "part", "part.meshb"] {
        let message = read(Path::new(path)).unwrap_err().to_string();
        assert!(
            message.contains(".msh, .vtu, .vtk, .mesh can be read, .vtu, .vtk, .mesh written"),
            "{message}"
        );
    }
    let refused = octruss_meshio::write(Path::new("part.msh"), &Dataset::default()).unwrap_err();
    assert!(
        refused.to_string().contains("Gmsh files are read, not written; .vtu, .vtk, .mesh can be"),
        "{refused}"
    );
}

#[test]
fn not_a_number_is_a_coordinate_that_the_check_will_find() {
    let dataset = read_bytes("vtu", &ascii(">0 0 0 1", ">0 0 nan 1")).unwrap();
    assert!(dataset.mesh.points[0][2].is_nan());
}

/// Sound files in every encoding that differs in how it is read.
fn sound_files() -> Vec<(&'static str, Vec<u8>)> {
    let base64 = base64("IAAAAAAAAAAAAAAAAQAAAAAAAAACAAAAAAAAAAMAAAAAAAAA");
    vec![
        ("vtu", raw(Compression::None)),
        ("vtu", raw(Compression::Zlib(6))),
        ("vtu", ASCII.into()),
        ("vtu", base64),
        ("vtk", LEGACY.into()),
        ("vtk", binary_legacy()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    /// Whatever happens to the bytes, reading ends, in a dataset or an error.
    #[test]
    fn damaged_files_are_read_or_refused(
        file in 0..6usize,
        changes in proptest::collection::vec((0.0..1.0f64, any::<u8>()), 0..12),
        kept in prop_oneof![Just(1.0), 0.0..1.0f64],
    ) {
        let (extension, mut bytes) = sound_files().swap_remove(file);
        for (place, value) in changes {
            // Cubed: more often in the header, where more depends on a byte.
            let at = (place.powi(3) * bytes.len() as f64) as usize;
            bytes[at] = value;
        }
        let _ = read_bytes(extension, &cut(bytes, kept));
    }
}
