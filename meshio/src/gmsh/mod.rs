//! Reading of Gmsh meshes: MSH 2.2 and 4.1, ASCII and binary.
//!
//! The format is described in Gmsh's manual,
//! <https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format>. A file is a
//! sequence of sections; one scanner reads numbers from text and binary
//! alike, so that each section is written once.

mod assemble;
mod data;
mod element_types;
mod elements;
mod entities;
mod header;
mod names;
mod nodes;
mod scanner;
mod sections;
mod tags;
mod v2;
mod v4;

use std::path::Path;

use assemble::Sections;
use data::Target;
use elements::Elements;
use entities::Entities;
use header::Version;
use nodes::Nodes;
use scanner::Scanner;
use tags::TagMap;

use crate::{Dataset, Error};

/// Reads a Gmsh mesh: MSH 2.0 to 2.2 or 4.1, ASCII or binary of either byte order.
///
/// Nodes keep the order of the file, tets the order of their corners. The
/// region of a tet is its first physical group, 0 for none. Triangles, lines
/// and points are listed once for each of their physical groups and left out
/// if they have none; a negative group turns them round. Second-order elements
/// are read as linear ones and their mid-side nodes dropped. `$NodeData`,
/// `$ElementData` and `$ElementNodeData` become fields (of tets and their corners
/// only), NaN where the file gives no value. The notes tell what was left out. Coordinates may be NaN or infinite:
/// checking the mesh finds that.
///
/// # Errors
/// [`Error::Io`] if the file cannot be read, [`Error::Malformed`] with line
/// (ASCII) or byte (binary) if it is not what the format prescribes, and
/// [`Error::Unsupported`] for other versions and for elements that are not simplices
/// of first or second order.
pub fn read(path: &Path) -> Result<Dataset, Error> {
    let bytes = std::fs::read(path).map_err(|source| Error::io(path, source))?;
    parse(path, &bytes)
}

/// Reads the content of a Gmsh file like [`read()`]; `path` serves the messages only.
///
/// ```
/// let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
///     $Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n\
///     $Elements\n1\n1 4 2 7 1 1 2 3 4\n$EndElements\n";
/// let dataset = octruss_meshio::gmsh::parse("tet.msh".as_ref(), text.as_bytes())?;
/// assert_eq!(dataset.mesh.tets, [[0, 1, 2, 3]]);
/// assert_eq!(dataset.mesh.regions, [7]);
/// # Ok::<(), octruss_meshio::Error>(())
/// ```
pub fn parse(path: &Path, bytes: &[u8]) -> Result<Dataset, Error> {
    let mut scanner = Scanner::new(path, bytes);
    let mut reader = Reader::new(header::read(&mut scanner)?);
    while let Some(name) = scanner.section()? {
        reader.section(&mut scanner, &name)?;
    }
    let nodes = reader.nodes.ok_or_else(|| missing(&scanner, "Nodes"))?;
    let elements = reader.elements.ok_or_else(|| missing(&scanner, "Elements"))?;
    Ok(assemble::dataset(nodes, elements, reader.sections))
}

/// The sections read so far.
struct Reader {
    version: Version,
    entities: Entities,
    nodes: Option<Nodes>,
    elements: Option<Elements>,
    /// From element tag to tet, once element data ask for it.
    tets: Option<TagMap>,
    sections: Sections,
}

impl Reader {
    fn new(version: Version) -> Self {
        Self {
            version,
            entities: Entities::default(),
            nodes: None,
            elements: None,
            tets: None,
            sections: Sections::default(),
        }
    }

    /// Reads the section `name` with its end.
    fn section(&mut self, scanner: &mut Scanner, name: &str) -> Result<(), Error> {
        match (name, self.version) {
            ("PhysicalNames", _) => self.sections.groups = names::read(scanner)?,
            ("Entities", Version::V4) => self.entities.read(scanner)?,
            ("PartitionedEntities", Version::V4) => self.entities.read_partitioned(scanner)?,
            ("Nodes", _) => self.nodes(scanner)?,
            ("Elements", _) => self.elements(scanner)?,
            ("NodeData", _) => {
                let nodes = earlier(scanner, &self.nodes, "Nodes", name)?;
                let field = data::read(scanner, &Target::Nodes(nodes))?;
                self.sections.point_data.extend(field);
            }
            ("ElementData" | "ElementNodeData", _) => {
                let elements = earlier(scanner, &self.elements, "Elements", name)?;
                let tets = self.tets.get_or_insert_with(|| TagMap::new(&elements.tet_tags).0);
                let count = elements.tets.len();
                let (target, fields) = match name {
                    "ElementData" => (Target::Tets(tets, count), &mut self.sections.cell_data),
                    _ => (Target::Corners(tets, count), &mut self.sections.corner_data),
                };
                fields.extend(data::read(scanner, &target)?);
            }
            ("ParametricNodes", _) => {
                return Err(scanner.unsupported(
                    "$ParametricNodes is not read; save without parametric coordinates \
                     (Mesh.SaveParametric = 0)",
                ));
            }
            _ => return self.skip(scanner, name),
        }
        scanner.end_section(name)
    }

    fn nodes(&mut self, scanner: &mut Scanner) -> Result<(), Error> {
        once(scanner, self.nodes.is_some(), "Nodes")?;
        self.nodes = Some(match self.version {
            Version::V2 => v2::nodes(scanner)?,
            Version::V4 => v4::nodes(scanner)?,
        });
        Ok(())
    }

    fn elements(&mut self, scanner: &mut Scanner) -> Result<(), Error> {
        once(scanner, self.elements.is_some(), "Elements")?;
        let nodes = earlier(scanner, &self.nodes, "Nodes", "Elements")?;
        let elements = match self.version {
            Version::V2 => v2::elements(scanner, nodes)?,
            Version::V4 => v4::elements(scanner, nodes, &self.entities)?,
        };
        elements.refuse_unsupported(scanner)?;
        self.elements = Some(elements);
        Ok(())
    }

    /// Passes over a section that is not needed, with a note if it may hold data.
    fn skip(&mut self, scanner: &mut Scanner, name: &str) -> Result<(), Error> {
        const NO_DATA: [&str; 5] =
            ["Comments", "Periodic", "GhostElements", "Parametrizations", "InterpolationScheme"];
        if !NO_DATA.contains(&name) {
            self.sections.notes.push(format!("the section ${name} was passed over"));
        }
        scanner.skip_past_line(&format!("$End{name}"))
    }
}

fn once(scanner: &Scanner, known: bool, name: &str) -> Result<(), Error> {
    if known {
        return Err(scanner.malformed(format!("a second section ${name}; expected one")));
    }
    Ok(())
}

fn earlier<'a, T>(
    scanner: &Scanner,
    section: &'a Option<T>,
    name: &str,
    user: &str,
) -> Result<&'a T, Error> {
    section.as_ref().ok_or_else(|| {
        scanner.malformed(format!(
            "${user} comes before ${name}, which it refers to; expected it after"
        ))
    })
}

fn missing(scanner: &Scanner, name: &str) -> Error {
    scanner.malformed(format!(
        "the file ends without a section ${name}: it is cut off or holds no mesh; \
         save the mesh with Gmsh again"
    ))
}
