//! Section after section, up to the end of the file.

use super::assemble::{self, Sections};
use super::data::{self, Target};
use super::elements::Elements;
use super::entities::Entities;
use super::header::{self, Version};
use super::nodes::Nodes;
use super::scanner::Scanner;
use super::tags::TagMap;
use super::{names, v2, v4};
use crate::dataset::Dataset;
use crate::notes;
use crate::problem::Problem;

/// The dataset in the bytes of a Gmsh file.
pub(super) fn parse(bytes: &[u8]) -> Result<Dataset, Problem> {
    let mut scanner = Scanner::new(bytes);
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
    fn section(&mut self, scanner: &mut Scanner, name: &str) -> Result<(), Problem> {
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
                return Err(Problem::unsupported(
                    "$ParametricNodes is not read; save without parametric coordinates \
                     (Mesh.SaveParametric = 0)",
                ));
            }
            _ => return self.skip(scanner, name),
        }
        scanner.end_section(name)
    }

    fn nodes(&mut self, scanner: &mut Scanner) -> Result<(), Problem> {
        once(scanner, self.nodes.is_some(), "Nodes")?;
        self.nodes = Some(match self.version {
            Version::V2 => v2::nodes(scanner)?,
            Version::V4 => v4::nodes(scanner)?,
        });
        Ok(())
    }

    fn elements(&mut self, scanner: &mut Scanner) -> Result<(), Problem> {
        once(scanner, self.elements.is_some(), "Elements")?;
        let nodes = earlier(scanner, &self.nodes, "Nodes", "Elements")?;
        let elements = match self.version {
            Version::V2 => v2::elements(scanner, nodes)?,
            Version::V4 => v4::elements(scanner, nodes, &self.entities)?,
        };
        elements.refuse_unsupported()?;
        self.elements = Some(elements);
        Ok(())
    }

    /// Passes over a section that is not needed, with a note if it may hold data.
    fn skip(&mut self, scanner: &mut Scanner, name: &str) -> Result<(), Problem> {
        const NO_DATA: [&str; 5] =
            ["Comments", "Periodic", "GhostElements", "Parametrizations", "InterpolationScheme"];
        if !NO_DATA.contains(&name) {
            self.sections.notes.push(notes::section(&format!("${name}")));
        }
        scanner.skip_past_line(&format!("$End{name}"))
    }
}

fn once(scanner: &Scanner, known: bool, name: &str) -> Result<(), Problem> {
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
) -> Result<&'a T, Problem> {
    section.as_ref().ok_or_else(|| {
        scanner.malformed(format!(
            "${user} comes before ${name}, which it refers to; expected it after"
        ))
    })
}

fn missing(scanner: &Scanner, name: &str) -> Problem {
    scanner.malformed(format!(
        "the file ends without a section ${name}: it is cut off or holds no mesh; \
         save the mesh with Gmsh again"
    ))
}
