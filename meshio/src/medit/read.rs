//! Medit files to datasets.

use std::collections::BTreeSet;

use octruss_mesh::RawMesh;

use super::header;
use super::words::{Section, Word, Words, is_keyword};
use crate::cell_kind::{CellKind, Simplex};
use crate::dataset::Dataset;
use crate::mid_side::MidSide;
use crate::notes;
use crate::problem::Problem;
use crate::text::{parse_text, quoted};

/// The dataset in the bytes of a Medit file.
pub(super) fn parse(bytes: &[u8]) -> Result<Dataset, Problem> {
    let mut words = Words::new(bytes);
    header::read(&mut words, bytes)?;
    let mut reader = Reader::default();
    while let Some(word) = words.take() {
        if word.text.eq_ignore_ascii_case(b"End") {
            reader.ended = true;
            break;
        }
        reader.section(&mut words, word)?;
    }
    reader.finish(&words)
}

/// What was read so far.
#[derive(Default)]
struct Reader {
    mesh: RawMesh,
    has_dimension: bool,
    has_vertices: bool,
    ended: bool,
    mid_side: MidSide,
    /// Vertices with a reference other than 0.
    references: usize,
    /// Triangles and edges with the reference 0.
    untagged: usize,
    passed_over: BTreeSet<String>,
    /// Keywords of cells that are not handled, and how many there are.
    unsupported: Vec<(&'static str, usize)>,
}

impl Reader {
    /// Reads what stands behind the keyword `word`.
    fn section(&mut self, words: &mut Words, word: Word) -> Result<(), Problem> {
        if !is_keyword(word.text) {
            return Err(words.malformed(
                word.place,
                format!(
                    "found {} where a keyword was expected, such as Tetrahedra: the section before \
                     it holds more than it announces",
                    quoted(word.text)
                ),
            ));
        }
        let name = String::from_utf8_lossy(word.text).into_owned();
        if name.eq_ignore_ascii_case("Dimension") {
            return self.dimension(words);
        }
        if name.eq_ignore_ascii_case("Vertices") {
            return self.vertices(words, word.place);
        }
        match CellKind::of_medit(&name) {
            Some((kind, keyword)) => self.cells(words, word.place, kind, keyword),
            None => self.pass_over(words, name),
        }
    }

    fn dimension(&mut self, words: &mut Words) -> Result<(), Problem> {
        let dimension = words.number(parse_text::<i64>, "3", format_args!("the dimension"))?;
        if dimension != 3 {
            return Err(Problem::unsupported(format!(
                "the mesh has dimension {dimension}; only meshes of tetrahedra, which have \
                 dimension 3, are read"
            )));
        }
        self.has_dimension = true;
        Ok(())
    }

    fn vertices(&mut self, words: &mut Words, place: usize) -> Result<(), Problem> {
        if self.has_vertices {
            return Err(words.malformed(place, "a second section Vertices; expected one"));
        }
        if !self.has_dimension {
            return Err(
                words.malformed(place, "Vertices comes before Dimension; expected it after")
            );
        }
        self.has_vertices = true;
        let section = words.section("Vertices", 4)?;
        if section.count >= u32::MAX as usize {
            let count = section.count;
            return Err(Problem::unsupported(format!(
                "{count} vertices are too many: fewer than 2^32 − 1 are read"
            )));
        }
        self.mesh.points.reserve(section.count);
        for _ in 0..section.count {
            let mut point = [0.0; 3];
            for coordinate in &mut point {
                *coordinate =
                    words.double(format_args!("a coordinate of {} Vertices", section.count))?;
            }
            self.mesh.points.push(point);
            self.references += usize::from(reference(words, section)? != 0);
        }
        Ok(())
    }

    fn cells(
        &mut self,
        words: &mut Words,
        place: usize,
        kind: &'static CellKind,
        keyword: &'static str,
    ) -> Result<(), Problem> {
        let section = words.section(keyword, kind.nodes + 1)?;
        let Some(simplex) = kind.simplex else {
            words.skip_numbers();
            self.count_unsupported(section);
            return Ok(());
        };
        if !self.has_vertices && section.count > 0 {
            return Err(words.malformed(
                place,
                format!("{keyword} comes before Vertices, which it refers to; expected it after"),
            ));
        }
        let mut nodes = vec![0; kind.nodes];
        for _ in 0..section.count {
            for node in &mut nodes {
                *node = self.vertex(words, section)?;
            }
            let tag = reference(words, section)?;
            self.add(simplex, &nodes, tag);
            self.mid_side.collect(kind, &nodes);
        }
        Ok(())
    }

    fn count_unsupported(&mut self, Section { keyword, count }: Section) {
        match self.unsupported.iter_mut().find(|(known, _)| *known == keyword) {
            Some((_, sum)) => *sum += count,
            None if count > 0 => self.unsupported.push((keyword, count)),
            None => {}
        }
    }

    /// A vertex of a cell, counted from 0.
    fn vertex(&self, words: &mut Words, section: Section) -> Result<u32, Problem> {
        let place = words.peek().map_or(0, |word| word.place);
        let Section { keyword, count } = section;
        let what = format_args!("a vertex of {count} {keyword}");
        let number = words.number(parse_text::<i64>, "a whole number", what)?;
        let points = self.mesh.points.len();
        match u32::try_from(number) {
            Ok(number) if (1..=points).contains(&(number as usize)) => Ok(number - 1),
            _ => Err(words.malformed(
                place,
                format!(
                    "{keyword} refers to the vertex {number}; expected 1 to {points}, for Medit \
                     counts the vertices from 1: write the file again with such numbers"
                ),
            )),
        }
    }

    /// Takes one cell in; cells of lower dimension only with a tag.
    fn add(&mut self, simplex: Simplex, nodes: &[u32], tag: i32) {
        match (simplex, nodes, tag) {
            (Simplex::Tet, &[a, b, c, d, ..], region) => {
                self.mesh.tets.push([a, b, c, d]);
                self.mesh.regions.push(region);
            }
            (_, _, 0) => self.untagged += 1,
            (Simplex::Triangle, &[a, b, c, ..], tag) => self.mesh.triangles.push([a, b, c], tag),
            (Simplex::Edge, &[a, b, ..], tag) => self.mesh.edges.push([a, b], tag),
            _ => {}
        }
    }

    /// Passes over a section that means nothing here.
    fn pass_over(&mut self, words: &mut Words, name: String) -> Result<(), Problem> {
        if name.to_ascii_lowercase().ends_with("ordering") {
            return Err(Problem::unsupported(format!(
                "the file has an order of nodes of its own ({name}), which is not read; save it \
                 with linear elements"
            )));
        }
        // A count alone announces nothing.
        if words.skip_numbers() > 1 {
            self.passed_over.insert(name);
        }
        Ok(())
    }

    fn finish(self, words: &Words) -> Result<Dataset, Problem> {
        if !self.unsupported.is_empty() {
            let list = self.unsupported.iter().map(|(keyword, count)| format!("{count} {keyword}"));
            let list: Vec<String> = list.collect();
            return Err(Problem::unsupported(format!(
                "the mesh has {}; only Tetrahedra, Triangles and Edges of first or second order \
                 are read: split other cells into tetrahedra first",
                list.join(", ")
            )));
        }
        if !self.has_vertices {
            return Err(words.cut_off("the section Vertices"));
        }
        let notes = self.notes();
        let mut dataset = Dataset { mesh: self.mesh, notes, ..Dataset::default() };
        self.mid_side.drop_from(&mut dataset);
        Ok(dataset)
    }

    fn notes(&self) -> Vec<String> {
        let of = |count: usize, note: fn(usize) -> String| (count > 0).then(|| note(count));
        [
            of(self.references, notes::vertex_references),
            of(self.untagged, notes::untagged),
            (!self.passed_over.is_empty()).then(|| notes::sections(&self.passed_over)),
            (!self.ended).then(notes::no_end),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

/// The last word of an entry.
fn reference(words: &mut Words, section: Section) -> Result<i32, Problem> {
    let Section { keyword, count } = section;
    let what = format_args!("a reference of {count} {keyword}");
    words.number(parse_text::<i32>, "a whole number of 32 bits with sign", what)
}
