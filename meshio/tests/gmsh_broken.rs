//! Broken Gmsh files, each made from a valid one by an edit: one clear message with a place.

use std::path::Path;

use octruss_meshio::parse;

const TET_22: &str = "\
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 7 \"solid\"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
$EndNodes
$Elements
1
1 4 2 7 1 1 2 3 4
$EndElements
";

const TET_41: &str = "\
$MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 0 1
1 0 0 0 1 1 1 1 7 0
$EndEntities
$Nodes
1 4 1 4
3 1 0 4
1
2
3
4
0 0 0
1 0 0
0 1 0
0 0 1
$EndNodes
$Elements
1 1 1 1
3 1 4 1
1 1 2 3 4
$EndElements
$NodeData
1
\"T\"
1
0.0
3
0
1
4
1 10
2 20
3 30
4 40
$EndNodeData
";

const BINARY_22: &[u8] = include_bytes!("data/gmsh/blocks-2.2-binary.msh");
const BINARY_41: &[u8] = include_bytes!("data/gmsh/blocks-4.1-binary.msh");

/// One broken file: what is wrong, its bytes, what the message must contain.
struct Broken {
    name: &'static str,
    bytes: Vec<u8>,
    expected: &'static [&'static str],
}

fn text(name: &'static str, text: impl Into<String>, expected: &'static [&'static str]) -> Broken {
    Broken { name, bytes: text.into().into_bytes(), expected }
}

/// The valid text with the one occurrence of `old` replaced.
fn edit(
    name: &'static str,
    valid: &str,
    old: &str,
    new: &str,
    expected: &'static [&'static str],
) -> Broken {
    assert_eq!(valid.matches(old).count(), 1, "{name}: what to replace must occur once");
    text(name, valid.replace(old, new), expected)
}

/// The text up to and with `last`.
fn cut(name: &'static str, valid: &str, last: &str, expected: &'static [&'static str]) -> Broken {
    let end = valid.find(last).expect("the cut") + last.len();
    text(name, &valid[..end], expected)
}

/// The valid bytes with `new` written `offset` bytes behind the line `marker`.
fn patch(
    name: &'static str,
    valid: &[u8],
    (marker, offset): (&str, usize),
    new: &[u8],
    expected: &'static [&'static str],
) -> Broken {
    let found = valid.windows(marker.len()).position(|window| window == marker.as_bytes());
    let at = found.expect("the marker") + marker.len() + offset;
    let mut bytes = valid.to_vec();
    bytes[at..at + new.len()].copy_from_slice(new);
    Broken { name, bytes, expected }
}

fn cut_bytes(
    name: &'static str,
    valid: &[u8],
    (marker, offset): (&str, usize),
    expected: &'static [&'static str],
) -> Broken {
    let mut broken = patch(name, valid, (marker, offset), &[], expected);
    let found = valid.windows(marker.len()).position(|window| window == marker.as_bytes());
    broken.bytes.truncate(found.expect("the marker") + marker.len() + offset);
    broken
}

fn assert_refused(rows: &[Broken]) {
    let wrong: Vec<String> = rows.iter().filter_map(complaint).collect();
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// What is wrong with the refusal of a file, if anything.
fn complaint(Broken { name, bytes, expected }: &Broken) -> Option<String> {
    let error = match parse(Path::new("folder/broken.msh"), bytes) {
        Ok(_) => return Some(format!("{name}: was read without an error")),
        Err(error) => error.to_string(),
    };
    let one_line = error.starts_with("folder/broken.msh") && !error.contains('\n');
    let missing = expected.iter().find(|&&part| !error.contains(part));
    match missing {
        Some(part) => Some(format!("{name}: expected {part:?} in: {error}")),
        None if !one_line => Some(format!("{name}: not one line with the path: {error}")),
        None => None,
    }
}

#[test]
fn the_valid_files_are_read() {
    for valid in [TET_22.as_bytes(), TET_41.as_bytes(), BINARY_22, BINARY_41] {
        parse("valid.msh".as_ref(), valid).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn files_that_are_something_else() {
    assert_refused(&[
        text("empty", "", &[":1: ", "empty", "expected $MeshFormat"]),
        text("blank", "\n  \n", &[":3: ", "empty"]),
        text("VTU", "<?xml version=\"1.0\"?>\n<VTKFile type=\"x\">\n", &[":1: ", "<?xml", ".vtu"]),
        text("legacy VTK", "# vtk DataFile Version 3.0\n", &[":1: ", ".vtk"]),
        text("garbage", "\u{7f}ELF\u{2}\u{1}\u{0}\u{0}\n", &[":1: ", "not a Gmsh mesh", "ELF"]),
        text("another section first", &TET_22[31..], &[":1: ", "$MeshFormat was expected"]),
        text("MSH 1", "$NOD\n1\n1 0 0 0\n$ENDNOD\n", &["version 1.0", "MSH 4.1 or 2.2"]),
        edit("version 3.7", TET_22, "2.2", "3.7", &["version 3.7", "MSH 4.1 or 2.2"]),
        edit("version 4.0", TET_41, "4.1 0", "4.0 0", &["version 4.0", "MSH 4.1 or 2.2"]),
        edit("version is text", TET_22, "2.2 0", "two 0", &[":2: ", "\"two\"", "4.1 or 2.2"]),
        edit("format too short", TET_22, "2.2 0 8", "2.2 0", &[":2: ", "data size"]),
        edit("file type 2", TET_22, "2.2 0", "2.2 2", &[":2: ", "file type is \"2\"", "0 (ASCII)"]),
    ]);
}

#[test]
fn text_that_is_cut_off() {
    assert_refused(&[
        cut("in the format", TET_22, "2.2 0 8\n", &[":3: ", "$EndMeshFormat", "cut off"]),
        cut("after the format", TET_22, "$EndMeshFormat\n", &[":4: ", "without a section $Nodes"]),
        cut("in the names", TET_22, "$PhysicalNames\n1\n", &[":6: ", "a physical name", "cut off"]),
        cut("in the entities", TET_41, "1 0 0 0 1 1", &[":6: ", "entity", "cut off"]),
        cut("in the nodes, 2.2", TET_22, "\n2 1 0", &[":9: ", "4 nodes", "cut off"]),
        cut("in the tags, 4.1", TET_41, "3 1 0 4\n1\n2\n3\n", &[":9: ", "only", "nodes"]),
        cut("in the nodes, 4.1", TET_41, "\n0 1 0\n", &[":10: ", "4 nodes of a block", "cut off"]),
        cut("without $EndNodes", TET_22, "4 0 0 1\n", &[":14: ", "$EndNodes", "cut off"]),
        cut("after the nodes", TET_22, "$EndNodes\n", &[":15: ", "without a section $Elements"]),
        cut("in the elements, 2.2", TET_22, "1 4 2 7 1 1", &[":17: ", "node tag", "cut off"]),
        cut(
            "in the elements, 4.1",
            TET_41,
            "1 1 2 3",
            &[":22: ", "1 elements of a block", "cut off"],
        ),
        cut(
            "in the data",
            TET_41,
            "2 20",
            &[":35: ", "the tag that a value belongs to", "cut off"],
        ),
        cut("without $EndNodeData", TET_41, "4 40\n", &[":38: ", "$EndNodeData", "cut off"]),
        edit(
            "unknown section without end",
            TET_22,
            "$Nodes",
            "$Knots",
            &[":19: ", "the line $EndKnots", "cut off"],
        ),
    ]);
}

#[test]
fn counts_that_are_absurd() {
    const HUGE: &str = "1000000000000000000";
    let nodes = format!("$Nodes\n{HUGE}\n");
    let elements = format!("$Elements\n{HUGE}\n");
    let total = format!("$Nodes\n1 {HUGE} 1 4\n");
    let block = format!("3 1 0 {HUGE}\n");
    let names = format!("$PhysicalNames\n{HUGE}\n");
    let entities = format!("$Entities\n0 0 0 {HUGE}\n");
    assert_refused(&[
        edit("nodes, 2.2", TET_22, "$Nodes\n4\n", &nodes, &[":9: ", HUGE, "bytes follow"]),
        edit(
            "negative",
            TET_22,
            "$Nodes\n4\n",
            "$Nodes\n-4\n",
            &[":9: ", "\"-4\"", "number of nodes"],
        ),
        edit(
            "too few nodes",
            TET_22,
            "$Nodes\n4\n",
            "$Nodes\n3\n",
            &[":13: ", "$EndNodes was expected"],
        ),
        edit(
            "too many nodes",
            TET_22,
            "$Nodes\n4\n",
            "$Nodes\n5\n",
            &[":14: ", "$EndNodes", "a node tag"],
        ),
        edit(
            "elements, 2.2",
            TET_22,
            "$Elements\n1\n",
            &elements,
            &[":16: ", HUGE, "bytes follow"],
        ),
        edit("nodes, 4.1", TET_41, "$Nodes\n1 4 1 4\n", &total, &[":9: ", HUGE, "bytes follow"]),
        edit("nodes of a block", TET_41, "3 1 0 4\n", &block, &[":10: ", HUGE, "bytes follow"]),
        edit(
            "elements of a block",
            TET_41,
            "3 1 4 1\n",
            "3 1 4 99\n",
            &[":22: ", "99 elements of a block"],
        ),
        edit("total of nodes", TET_41, "1 4 1 4\n", "1 5 1 4\n", &[":19: ", "5 nodes", "hold 4"]),
        edit(
            "total of elements",
            TET_41,
            "1 1 1 1\n",
            "1 2 1 1\n",
            &[":24: ", "2 elements", "hold 1"],
        ),
        edit(
            "physical names",
            TET_22,
            "$PhysicalNames\n1\n",
            &names,
            &[":7: ", "$EndPhysicalNames"],
        ),
        edit(
            "entities",
            TET_41,
            "$Entities\n0 0 0 1\n",
            &entities,
            &[":7: ", "$EndEntities", "entity tag"],
        ),
        edit(
            "too large for any count",
            TET_41,
            "3 1 0 4\n",
            "3 1 0 99999999999999999999999\n",
            &[":10: ", "99999"],
        ),
    ]);
}

#[test]
fn text_that_says_nonsense() {
    let quads = "1 3 2 7 1 1 2 3 4";
    assert_refused(&[
        edit(
            "missing node, 2.2",
            TET_22,
            "7 1 1 2 3 4",
            "7 1 1 2 3 9",
            &[":17: ", "node 9", "$Nodes has none"],
        ),
        edit(
            "missing node, 4.1",
            TET_41,
            "1 1 2 3 4",
            "1 1 2 3 9",
            &[":23: ", "node 9", "$Nodes has none"],
        ),
        edit(
            "node tag twice, 2.2",
            TET_22,
            "\n3 0 1 0",
            "\n2 0 1 0",
            &[":12: ", "node tag 2", "second time"],
        ),
        edit(
            "node tag twice, 4.1",
            TET_41,
            "\n3\n4\n0 0",
            "\n3\n1\n0 0",
            &[":14: ", "node tag 1", "second time"],
        ),
        edit("not a number", TET_22, "3 0 1 0", "3 0 one 0", &[":12: ", "\"one\"", "coordinate"]),
        edit(
            "node without z",
            TET_22,
            "3 0 1 0\n",
            "3 0 1\n",
            &[":12: ", "the line ends", "coordinate"],
        ),
        edit(
            "four coordinates",
            TET_22,
            "3 0 1 0\n",
            "3 0 1 0 5\n",
            &[":12: ", "\"5\"", "end of the line"],
        ),
        edit("negative node tag", TET_41, "\n2\n", "\n-2\n", &[":12: ", "\"-2\"", "0 or more"]),
        edit(
            "element short of a node",
            TET_22,
            "7 1 1 2 3 4",
            "7 1 1 2 3",
            &[":17: ", "the line ends", "node tag"],
        ),
        edit("unknown element", TET_22, "1 4 2 7", "1 444 2 7", &[":17: ", "444", "element type"]),
        edit(
            "quad",
            TET_22,
            "1 4 2 7 1 1 2 3 4",
            quads,
            &["1 quadrangles (element type 3)", "only tetrahedra"],
        ),
        edit(
            "element type 4.5",
            TET_22,
            "1 4 2 7",
            "1 4.5 2 7",
            &[":17: ", "\"4.5\"", "element type"],
        ),
        edit("parametric 3", TET_41, "3 1 0 4", "3 1 3 4", &[":10: ", "expected 0 or 1"]),
        edit("name without quotes", TET_22, "\"solid\"", "solid", &[":6: ", "name in quotes"]),
        edit("name of dimension 4", TET_22, "3 7 \"", "4 7 \"", &[":6: ", "dimension (0 to 3)"]),
        edit(
            "two names",
            TET_22,
            "1\n3 7 \"solid\"",
            "2\n3 7 \"solid\"\n3 7 \"stone\"",
            &[":8: ", "group 7 of dimension 3 has two names"],
        ),
        edit(
            "stray text",
            TET_22,
            "$Elements\n",
            "Elements\n",
            &[":15: ", "\"Elements\"", "a section"],
        ),
        edit(
            "wrong end",
            TET_22,
            "$EndNodes",
            "$EndNods",
            &[":14: ", "$EndNods", "$EndNodes was expected"],
        ),
        text(
            "elements first",
            TET_22
                .replace("Nodes", "X")
                .replace("Elements", "Nodes")
                .replace("$X", "$Elements")
                .replace("$EndX", "$EndElements"),
            &[":9: ", "$Elements comes before $Nodes"],
        ),
        text(
            "nodes twice",
            TET_22.replace("Elements", "Nodes"),
            &[":16: ", "second section $Nodes"],
        ),
        edit(
            "data of a missing node",
            TET_41,
            "2 20",
            "5 20",
            &[":35: ", "node 5", "$Nodes has none"],
        ),
        edit(
            "two components",
            TET_41,
            "\n1\n4\n1 10",
            "\n2\n4\n1 10",
            &[":32: ", "\"2\"", "1, 3 or 9"],
        ),
        edit(
            "two integer tags",
            TET_41,
            "\n3\n0\n1\n4\n1 10",
            "\n2\n0\n1\n4\n1 10",
            &[":30: ", "at least 3"],
        ),
        edit(
            "more data than announced",
            TET_41,
            "\n4\n1 10",
            "\n3\n1 10",
            &[":37: ", "$EndNodeData was expected"],
        ),
    ]);
}

#[test]
fn binary_files() {
    let huge = 1_000_000_000_000_000_000_u64.to_le_bytes();
    assert_refused(&[
        patch(
            "byte order",
            BINARY_41,
            ("4.1 1 8\n", 0),
            &[0, 7, 0, 0],
            &["at byte ", "byte order"],
        ),
        patch("data size", BINARY_41, ("4.1 1 ", 0), b"4", &["size \"4\"", "only 8"]),
        patch(
            "nodes, 4.1",
            BINARY_41,
            ("$Nodes\n", 8),
            &huge,
            &["at byte ", "1000000000000000000 nodes"],
        ),
        patch(
            "negative",
            BINARY_41,
            ("$Nodes\n", 8),
            &[0xff; 8],
            &["at byte ", "18446744073709551615"],
        ),
        patch("other byte order", BINARY_41, ("4.1 1 8\n", 0), &[0, 0, 0, 1], &["at byte "]),
        patch("entities", BINARY_41, ("$Entities\n", 0), &huge, &["at byte ", "cut off"]),
        patch(
            "element type",
            BINARY_22,
            ("$Elements\n592\n", 0),
            &[200, 0, 0, 0],
            &["at byte ", "200"],
        ),
        patch(
            "block",
            BINARY_22,
            ("$Elements\n592\n", 4),
            &[0xff; 4],
            &["at byte ", "is -1", "0 or more"],
        ),
        patch(
            "empty block",
            BINARY_22,
            ("$Elements\n592\n", 4),
            &[0; 4],
            &["at byte ", "0 elements"],
        ),
        cut_bytes(
            "in the nodes, 2.2",
            BINARY_22,
            ("$Nodes\n117\n", 40),
            &["at byte ", "117 nodes", "40 bytes"],
        ),
        cut_bytes("in the nodes, 4.1", BINARY_41, ("$Nodes\n", 70), &["at byte ", "117 nodes"]),
        cut_bytes(
            "in the elements, 2.2",
            BINARY_22,
            ("$Elements\n592\n", 6000),
            &["at byte ", "cut off"],
        ),
        cut_bytes("in the elements, 4.1", BINARY_41, ("$Elements\n", 500), &["at byte "]),
        cut_bytes(
            "without $EndNodes",
            BINARY_22,
            ("$Nodes\n117\n", 117 * 28 + 1),
            &["at byte ", "$EndNodes"],
        ),
    ]);
}

#[test]
fn a_file_that_does_not_exist_is_named() {
    let error = octruss_meshio::read("no/such/file.msh".as_ref()).unwrap_err().to_string();
    assert!(error.contains("no/such/file.msh"), "{error}");
}
