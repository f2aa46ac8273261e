//! The values of an array, wherever and however a VTU file keeps them.

use std::borrow::Cow;

use super::array_tag::{ArrayKind, ArrayTag, Source};
use super::base64;
use super::blocks;
use super::header::Header;
use super::number::{self, ByteOrder, NumberType, Whole};
use crate::dataset::Values;
use crate::problem::Problem;

/// Finds and decodes the arrays of one file.
pub(crate) struct Decoder<'a> {
    header: &'a Header<'a>,
    /// Where arrays begin in the appended section, ascending.
    offsets: Vec<u64>,
}

/// The numbers of one array, not yet widened.
pub(crate) struct Numbers<'a> {
    part: String,
    kind: NumberType,
    order: ByteOrder,
    content: Content<'a>,
}

enum Content<'a> {
    Text(&'a str),
    Bytes(Cow<'a, [u8]>),
}

/// What an array is called in messages.
pub(crate) fn part(name: &str) -> String {
    format!("array `{name}`")
}

impl<'a> Decoder<'a> {
    /// A decoder for the arrays of `header`.
    pub(crate) fn new(header: &'a Header<'a>) -> Self {
        let lists = header.pieces.iter().flat_map(|piece| {
            [&piece.point_data, &piece.cell_data, &piece.positions, &piece.topology]
        });
        let mut offsets: Vec<u64> = lists
            .chain([&header.field_data])
            .flatten()
            .filter_map(|array| match array.source {
                Source::Appended(offset) => Some(offset),
                _ => None,
            })
            .collect();
        offsets.sort_unstable();
        Self { header, offsets }
    }

    /// The numbers of an array.
    pub(crate) fn numbers(&self, array: &'a ArrayTag<'a>) -> Result<Numbers<'a>, Problem> {
        let part = part(&array.name);
        let ArrayKind::Numbers(kind) = array.kind else {
            return Err(Problem::part(part, "the array should hold numbers"));
        };
        let content = self.content(array)?;
        if let Content::Bytes(bytes) = &content
            && bytes.len() % kind.width() != 0
        {
            let message = format!("{} bytes are no whole number of {}", bytes.len(), kind.name());
            return Err(Problem::part(part, message));
        }
        Ok(Numbers { part, kind, order: self.header.packing.order, content })
    }

    fn content(&self, array: &'a ArrayTag<'a>) -> Result<Content<'a>, Problem> {
        let packing = self.header.packing;
        let refused = |message: String| Problem::part(part(&array.name), message);
        let packed = match &array.source {
            Source::Ascii(text) => return Ok(Content::Text(text)),
            Source::Base64(text) if text.trim().is_empty() => {
                return Ok(Content::Bytes(Cow::Borrowed(&[])));
            }
            Source::Base64(text) => Cow::Owned(base64::decode(text.as_bytes()).map_err(refused)?),
            Source::Appended(offset) => self.appended(*offset).map_err(refused)?,
        };
        blocks::unpack(packed, packing).map(Content::Bytes).map_err(refused)
    }

    /// The appended section from `offset` on; at least to the end of the array there.
    fn appended(&self, offset: u64) -> Result<Cow<'a, [u8]>, String> {
        let Some(section) = &self.header.appended else {
            return Err("is said to be appended, but the file has no <AppendedData>".into());
        };
        let length = section.bytes.len();
        let Some(rest) = usize::try_from(offset).ok().and_then(|start| section.bytes.get(start..))
        else {
            return Err(format!(
                "offset {offset} lies beyond the {length} bytes of the section: \
                 the file is cut off or damaged"
            ));
        };
        if !section.base64 {
            return Ok(Cow::Borrowed(rest));
        }
        let next = self.offsets.partition_point(|&other| other <= offset);
        let end = self.offsets.get(next).map_or(u64::MAX, |&other| other - offset);
        let text = &rest[..rest.len().min(end.try_into().unwrap_or(usize::MAX))];
        let end = text.iter().position(|&byte| byte == b'<').unwrap_or(text.len());
        base64::decode(&text[..end]).map(Cow::Owned)
    }
}

impl Numbers<'_> {
    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        match &self.content {
            Content::Text(text) => text.split_ascii_whitespace().count(),
            Content::Bytes(bytes) => bytes.len() / self.kind.width(),
        }
    }

    /// Fails unless there are `components` × `tuples`, of which `counted` tells
    /// where the number of tuples comes from.
    pub(crate) fn expect(
        &self,
        components: usize,
        tuples: u64,
        counted: &str,
    ) -> Result<usize, Problem> {
        let length = self.len();
        if tuples.checked_mul(components as u64) == Some(length as u64) {
            return Ok(length);
        }
        let message =
            format!("holds {length} numbers; expected {components} for each of {tuples} {counted}");
        Err(Problem::part(&self.part, message))
    }

    /// All of them as floating-point numbers; `target` has their length.
    pub(crate) fn floats(&self, target: &mut [f64]) -> Result<(), Problem> {
        let text = match &self.content {
            Content::Bytes(bytes) => {
                number::floats_from_bytes(bytes, self.kind, self.order, target);
                return Ok(());
            }
            Content::Text(text) => text,
        };
        self.words(text, target, "a number", |word| match self.kind {
            // As precise as the file says, no more.
            NumberType::Float32 => word.parse::<f32>().ok().map(f64::from),
            _ => word.parse().ok(),
        })
    }

    /// All of them as whole numbers; `target` has their length, `expected` names
    /// in messages what every one must be.
    pub(crate) fn wholes<T: Whole>(&self, target: &mut [T], expected: &str) -> Result<(), Problem> {
        match &self.content {
            Content::Bytes(bytes) => number::wholes_from_bytes(
                bytes, self.kind, self.order, target,
            )
            .map_err(|position| {
                Problem::part(&self.part, format!("value number {position} is not {expected}"))
            }),
            Content::Text(text) => self.words(text, target, expected, |word| {
                let whole = word.parse::<i128>().ok();
                whole
                    .or_else(|| number::whole_float(word.parse().ok()?))
                    .and_then(|v| v.try_into().ok())
            }),
        }
    }

    fn words<T>(
        &self,
        text: &str,
        target: &mut [T],
        expected: &str,
        parse: impl Fn(&str) -> Option<T>,
    ) -> Result<(), Problem> {
        for (slot, word) in target.iter_mut().zip(text.split_ascii_whitespace()) {
            let refused = || {
                let shown: String = word.chars().take(40).collect();
                Problem::part(&self.part, format!("`{shown}` is not {expected}"))
            };
            *slot = parse(word).ok_or_else(refused)?;
        }
        Ok(())
    }

    /// All of them, widened.
    pub(crate) fn values(&self) -> Result<Values, Problem> {
        let length = self.len();
        if self.kind.is_float() {
            let mut values = vec![0.0; length];
            self.floats(&mut values)?;
            return Ok(Values::Float(values));
        }
        let mut values = vec![0; length];
        self.wholes(&mut values, "a whole number of 64 bits with sign")?;
        Ok(Values::Integer(values))
    }
}
