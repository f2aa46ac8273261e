//! `$MeshFormat`: the version and how numbers are written.

use super::scanner::{Encoding, Scanner};
use crate::problem::Problem;
use crate::text::{parse_text, quoted};

/// The layouts that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// 2.0 to 2.2: each element carries its tags.
    V2,
    /// 4.1: nodes and elements in blocks, an entity each.
    V4,
}

/// Reads the first section and sets the scanner's encoding.
pub fn read(scanner: &mut Scanner) -> Result<Version, Problem> {
    scanner.skip_blank();
    while scanner.rest().starts_with(b"$Comments") {
        scanner.skip_past_line("$EndComments")?;
        scanner.skip_blank();
    }
    find_start(scanner)?;
    let start = scanner.position();
    let line = scanner.line("the file format (version, file type, data size)")?;
    let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let (Some(number), Some(file_type), Some(data_size), None) =
        (words.next(), words.next(), words.next(), words.next())
    else {
        return Err(scanner.malformed_at(
            start,
            format!(
                "found {}; expected version, file type and data size, such as \"4.1 0 8\"",
                quoted(line)
            ),
        ));
    };
    let version = version(scanner, start, number)?;
    match file_type {
        b"0" => {}
        b"1" => {
            if data_size != b"8" {
                return Err(Problem::unsupported(format!(
                    "binary data of size {} cannot be read, only 8; save the mesh again \
                     with a 64-bit Gmsh or as ASCII",
                    quoted(data_size)
                )));
            }
            read_byte_order(scanner)?;
        }
        _ => {
            return Err(scanner.malformed_at(
                start,
                format!("the file type is {}; expected 0 (ASCII) or 1 (binary)", quoted(file_type)),
            ));
        }
    }
    scanner.end_section("MeshFormat")?;
    Ok(version)
}

fn find_start(scanner: &mut Scanner) -> Result<(), Problem> {
    let (start, rest) = (scanner.position(), scanner.rest());
    if rest.is_empty() {
        return Err(scanner.malformed("the file is empty; expected $MeshFormat of a Gmsh mesh"));
    }
    if rest.starts_with(b"$NOD") || rest.starts_with(b"$PARA") {
        return Err(unsupported_version("1.0"));
    }
    match scanner.section() {
        Ok(Some(name)) if name == "MeshFormat" => Ok(()),
        _ => Err(not_gmsh(scanner, start, rest)),
    }
}

/// The file starts with something else: tell what it looks like.
fn not_gmsh(scanner: &Scanner, start: usize, rest: &[u8]) -> Problem {
    let line = rest.split(|&byte| byte == b'\n').next().unwrap_or_default().trim_ascii();
    let advice = if line.starts_with(b"<") {
        "it looks like XML; if it is a VTK file, name it .vtu"
    } else if line.starts_with(b"# vtk") {
        "it looks like a legacy VTK file; name it .vtk"
    } else {
        "save the mesh with Gmsh as MSH 4.1 or 2.2"
    };
    scanner.malformed_at(
        start,
        format!("not a Gmsh mesh: found {} where $MeshFormat was expected; {advice}", quoted(line)),
    )
}

fn version(scanner: &Scanner, start: usize, text: &[u8]) -> Result<Version, Problem> {
    let number: f64 = parse_text(text).ok_or_else(|| {
        scanner.malformed_at(start, format!("the version is {}; expected 4.1 or 2.2", quoted(text)))
    })?;
    if (2.0..=2.2).contains(&number) {
        Ok(Version::V2)
    } else if number == 4.1 {
        Ok(Version::V4)
    } else {
        Err(unsupported_version(&String::from_utf8_lossy(text)))
    }
}

fn unsupported_version(version: &str) -> Problem {
    Problem::unsupported(format!(
        "the Gmsh file has version {version}, which is not read; save as MSH 4.1 or 2.2 \
         (Gmsh option Mesh.MshFileVersion)"
    ))
}

/// Binary files hold the 32-bit number one to show their byte order.
fn read_byte_order(scanner: &mut Scanner) -> Result<(), Problem> {
    scanner.encoding = Encoding::LittleEndian;
    let start = scanner.position();
    match scanner.int("the number one, which shows the byte order")? {
        1 => Ok(()),
        other if other.swap_bytes() == 1 => {
            scanner.encoding = Encoding::BigEndian;
            Ok(())
        }
        other => Err(scanner.malformed_at(
            start,
            format!(
                "found {other} where the number one was expected, which shows the byte \
                 order: the file is damaged, perhaps by a transfer as text"
            ),
        )),
    }
}
