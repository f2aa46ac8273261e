//! What the attributes of a VTU file's elements mean.

use std::borrow::Cow;

use quick_xml::XmlVersion;
use quick_xml::events::BytesStart;

use super::array_tag::{ArrayKind, ArrayTag, Source};
use super::blocks::Packing;
use super::number::{ByteOrder, NumberType};
use crate::problem::Problem;

/// VTK counts components in 32 bits with sign; more would only overflow sizes.
const MOST_COMPONENTS: u64 = i32::MAX as u64;

/// The attributes of one element, decoded.
pub(crate) struct Attributes {
    element: String,
    values: Vec<(String, String)>,
}

impl Attributes {
    pub(crate) fn of(start: &BytesStart<'_>) -> Result<Self, Problem> {
        let element = start.name().as_ref().to_string();
        let broken = |reason: String| {
            Problem::whole(format!("the attributes of <{element}> are broken: {reason}"))
        };
        let mut values = Vec::new();
        for attribute in start.attributes() {
            let attribute = attribute.map_err(|reason| broken(reason.to_string()))?;
            let value = attribute
                .normalized_value(XmlVersion::Implicit1_0)
                .map_err(|reason| broken(reason.to_string()))?;
            values.push((attribute.key.as_ref().to_string(), value.into_owned()));
        }
        Ok(Self { element, values })
    }

    fn get(&self, key: &str) -> Option<&str> {
        self.values.iter().find(|(name, _)| name == key).map(|(_, value)| value.as_str())
    }

    /// A count; nothing guarantees that it is true.
    pub(crate) fn count(&self, key: &str) -> Result<u64, Problem> {
        let element = &self.element;
        let Some(text) = self.get(key) else {
            return Err(Problem::whole(format!("<{element}> lacks the attribute {key}")));
        };
        text.trim()
            .parse()
            .map_err(|_| Problem::whole(format!("{key}=\"{text}\" of <{element}> is not a count")))
    }
}

/// How `<VTKFile>` says that arrays are packed.
pub(crate) fn packing(attributes: &Attributes) -> Result<Packing, Problem> {
    match attributes.get("type") {
        Some("UnstructuredGrid") => {}
        Some(other) => {
            return Err(Problem::unsupported(format!(
                "this VTK file holds {other}; only UnstructuredGrid (.vtu) is read"
            )));
        }
        None => return Err(Problem::whole("<VTKFile> lacks the attribute type")),
    }
    let order = match attributes.get("byte_order") {
        None | Some("LittleEndian") => ByteOrder::Little,
        Some("BigEndian") => ByteOrder::Big,
        Some(other) => return Err(Problem::whole(format!("unknown byte_order=\"{other}\""))),
    };
    let header_width = match attributes.get("header_type") {
        None | Some("UInt32") => 4,
        Some("UInt64") => 8,
        Some(other) => return Err(Problem::whole(format!("unknown header_type=\"{other}\""))),
    };
    let compressed = match attributes.get("compressor") {
        None | Some("") => false,
        Some("vtkZLibDataCompressor") => true,
        Some(other) => {
            return Err(Problem::unsupported(format!(
                "the arrays are compressed by {other}, which is not read; save the file without \
                 compression or with vtkZLibDataCompressor (in ParaView: Compressor Type)"
            )));
        }
    };
    Ok(Packing { order, header_width, compressed })
}

/// Whether `<AppendedData>` is in base64, else raw.
pub(crate) fn appended_encoding(attributes: &Attributes) -> Result<bool, Problem> {
    match attributes.get("encoding") {
        None | Some("base64") => Ok(true),
        Some("raw") => Ok(false),
        Some(other) => Err(Problem::whole(format!("unknown encoding=\"{other}\" of AppendedData"))),
    }
}

/// The array that a `<DataArray>` announces, still without its text.
pub(crate) fn array<'a>(attributes: &Attributes) -> Result<ArrayTag<'a>, Problem> {
    let name = attributes.get("Name").unwrap_or_default().to_string();
    let part = format!("array `{name}`");
    let kind = match attributes.get("type") {
        Some("String" | "Bit") => ArrayKind::Other,
        Some(other) => ArrayKind::Numbers(NumberType::named(other).ok_or_else(|| {
            Problem::part(
                &part,
                format!("unknown type \"{other}\"; expected one such as Float64 or Int32"),
            )
        })?),
        None => return Err(Problem::part(part, "the attribute type is missing")),
    };
    let components = match attributes.get("NumberOfComponents") {
        None => 1,
        Some(_) => match attributes.count("NumberOfComponents")? {
            count @ 1..=MOST_COMPONENTS => count as usize,
            count => {
                let message = format!("NumberOfComponents is {count}, not from 1 to 2147483647");
                return Err(Problem::part(part, message));
            }
        },
    };
    let source = match attributes.get("format") {
        None | Some("ascii") => Source::Ascii(Cow::Borrowed("")),
        Some("binary") => Source::Base64(Cow::Borrowed("")),
        Some("appended") => Source::Appended(attributes.count("offset")?),
        Some(other) => {
            return Err(Problem::part(
                part,
                format!("unknown format=\"{other}\"; expected ascii, binary or appended"),
            ));
        }
    };
    Ok(ArrayTag { name, kind, components, source })
}
