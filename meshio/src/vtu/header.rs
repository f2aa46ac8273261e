//! The XML of a VTU file: which arrays there are, and where their values lie.

use std::borrow::Cow;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::array_tag::{ArrayTag, Source};
use super::attributes::{Attributes, appended_encoding, array, packing};
use super::blocks::Packing;
use crate::error::Place;
use crate::problem::Problem;
use crate::text::line_at;

/// What the XML says, and the bytes that it refers to.
#[derive(Debug)]
pub(crate) struct Header<'a> {
    pub(crate) packing: Packing,
    pub(crate) field_data: Vec<ArrayTag<'a>>,
    pub(crate) pieces: Vec<Piece<'a>>,
    pub(crate) appended: Option<Appended<'a>>,
}

/// One `<Piece>`: a mesh with vertex numbers of its own.
#[derive(Debug, Default)]
pub(crate) struct Piece<'a> {
    /// As the file states it; not to be trusted.
    pub(crate) points: u64,
    /// As the file states it; not to be trusted.
    pub(crate) cells: u64,
    pub(crate) point_data: Vec<ArrayTag<'a>>,
    pub(crate) cell_data: Vec<ArrayTag<'a>>,
    pub(crate) positions: Vec<ArrayTag<'a>>,
    pub(crate) topology: Vec<ArrayTag<'a>>,
}

/// The appended section, from behind its underscore.
#[derive(Debug)]
pub(crate) struct Appended<'a> {
    pub(crate) base64: bool,
    /// Up to the end of the file, the closing tags included.
    pub(crate) bytes: &'a [u8],
}

/// An open element of the XML.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Element {
    File,
    Grid,
    FieldData,
    Piece,
    PointData,
    CellData,
    Points,
    Cells,
    Array,
    Appended,
    /// Anything else, such as an array's `InformationKey`: left out with all in it.
    Foreign,
}

/// Parses the XML part of `bytes`, up to the appended section if there is one.
pub(crate) fn parse(bytes: &[u8]) -> Result<Header<'_>, Problem> {
    let xml_end = end_of_xml(bytes);
    let text = std::str::from_utf8(&bytes[..xml_end]).map_err(|reason| {
        Problem::Malformed(
            Place::Byte(reason.valid_up_to()),
            "this is not text in UTF-8, and so not the XML of a VTU file".into(),
        )
    })?;
    let mut parser = Parser::default();
    let mut reader = Reader::from_str(text);
    reader.config_mut().expand_empty_elements = true;
    loop {
        let event = reader.read_event().map_err(|reason| {
            let line = line_at(bytes, reader.error_position() as usize);
            Problem::Malformed(Place::Line(line), format!("the XML is broken: {reason}"))
        })?;
        if matches!(event, Event::Eof) {
            break;
        }
        parser.event(event).map_err(|problem| match problem {
            Problem::Malformed(Place::Whole, message) => Problem::Malformed(
                Place::Line(line_at(bytes, reader.buffer_position() as usize)),
                message,
            ),
            other => other,
        })?;
    }
    parser.finish(&bytes[xml_end..])
}

/// Behind the opening tag of the appended section, whose content need not be
/// text; or the end of the file.
fn end_of_xml(bytes: &[u8]) -> usize {
    let tag = b"<AppendedData";
    let mut from = 0;
    while let Some(step) = bytes[from..].iter().position(|&byte| byte == b'<') {
        let start = from + step;
        if bytes[start..].starts_with(tag) {
            let close = bytes[start..].iter().position(|&byte| byte == b'>');
            return close.map_or(bytes.len(), |close| start + close + 1);
        }
        from = start + 1;
    }
    bytes.len()
}

#[derive(Default)]
struct Parser<'a> {
    open: Vec<Element>,
    packing: Option<Packing>,
    field_data: Vec<ArrayTag<'a>>,
    pieces: Vec<Piece<'a>>,
    saw_grid: bool,
    appended_is_base64: Option<bool>,
}

impl<'a> Parser<'a> {
    fn event(&mut self, event: Event<'a>) -> Result<(), Problem> {
        match event {
            Event::Start(start) => {
                let element = self.opening(&start)?;
                self.open.push(element);
            }
            Event::End(_) => {
                self.open.pop();
            }
            Event::Text(text) if self.open.last() == Some(&Element::Array) => {
                self.array_text(text.into_inner())?;
            }
            _ => {}
        }
        Ok(())
    }

    fn opening(&mut self, start: &BytesStart<'_>) -> Result<Element, Problem> {
        let attributes = Attributes::of(start)?;
        let name = start.name();
        let parent = self.open.last().copied();
        Ok(match (parent, name.as_ref()) {
            (None, "VTKFile") => {
                self.packing = Some(packing(&attributes)?);
                Element::File
            }
            (None, other) => {
                return Err(Problem::whole(format!(
                    "the outermost element is <{other}>, not <VTKFile>: this is no VTU file"
                )));
            }
            (Some(Element::File), "UnstructuredGrid") => {
                self.saw_grid = true;
                Element::Grid
            }
            (Some(Element::File), "AppendedData") => {
                self.appended_is_base64 = Some(appended_encoding(&attributes)?);
                Element::Appended
            }
            (Some(Element::Grid), "FieldData") => Element::FieldData,
            (Some(Element::Grid), "Piece") => {
                self.pieces.push(Piece {
                    points: attributes.count("NumberOfPoints")?,
                    cells: attributes.count("NumberOfCells")?,
                    ..Piece::default()
                });
                Element::Piece
            }
            (Some(Element::Piece), "PointData") => Element::PointData,
            (Some(Element::Piece), "CellData") => Element::CellData,
            (Some(Element::Piece), "Points") => Element::Points,
            (Some(Element::Piece), "Cells") => Element::Cells,
            (Some(parent), "DataArray" | "Array") => match self.list(parent) {
                Some(list) => {
                    list.push(array(&attributes)?);
                    Element::Array
                }
                None if parent == Element::Foreign => Element::Foreign,
                None => return Err(misplaced(name.as_ref(), parent)),
            },
            (Some(parent), other @ ("Piece" | "Points" | "Cells" | "PointData" | "CellData")) => {
                return Err(misplaced(other, parent));
            }
            (Some(_), _) => Element::Foreign,
        })
    }

    /// The list that an array inside `parent` belongs to.
    fn list(&mut self, parent: Element) -> Option<&mut Vec<ArrayTag<'a>>> {
        match parent {
            Element::FieldData => Some(&mut self.field_data),
            Element::PointData => Some(&mut self.pieces.last_mut()?.point_data),
            Element::CellData => Some(&mut self.pieces.last_mut()?.cell_data),
            Element::Points => Some(&mut self.pieces.last_mut()?.positions),
            Element::Cells => Some(&mut self.pieces.last_mut()?.topology),
            _ => None,
        }
    }

    fn array_text(&mut self, text: Cow<'a, str>) -> Result<(), Problem> {
        let parent = self.open[self.open.len() - 2];
        let array = self.list(parent).and_then(|list| list.last_mut());
        match array.map(|array| &mut array.source) {
            Some(Source::Ascii(held) | Source::Base64(held)) if held.trim().is_empty() => {
                *held = text
            }
            Some(Source::Ascii(held) | Source::Base64(held)) => held.to_mut().push_str(&text),
            Some(Source::Appended(_)) if !text.trim().is_empty() => {
                return Err(Problem::whole("an array with format=\"appended\" holds text, too"));
            }
            _ => {}
        }
        Ok(())
    }

    fn finish(self, behind: &'a [u8]) -> Result<Header<'a>, Problem> {
        let Some(packing) = self.packing else {
            return Err(Problem::whole("there is no <VTKFile> element: this is no VTU file"));
        };
        let complete = match self.appended_is_base64 {
            Some(_) => self.open == [Element::File, Element::Appended],
            None => self.open.is_empty(),
        };
        if !complete {
            return Err(Problem::whole(
                "the XML ends before all its elements are closed: the file is cut off or damaged",
            ));
        }
        if !self.saw_grid {
            return Err(Problem::whole("there is no <UnstructuredGrid> element in the file"));
        }
        let appended = match self.appended_is_base64 {
            None => None,
            Some(base64) => {
                let blank = behind.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
                let Some(bytes) = behind[blank..].strip_prefix(b"_") else {
                    return Err(Problem::part(
                        "AppendedData",
                        "the section does not start with `_`",
                    ));
                };
                Some(Appended { base64, bytes })
            }
        };
        Ok(Header { packing, field_data: self.field_data, pieces: self.pieces, appended })
    }
}

fn misplaced(name: &str, parent: Element) -> Problem {
    Problem::whole(format!("a <{name}> inside {parent:?} is out of place"))
}
