//! What the XML says about one array.

use std::borrow::Cow;

use super::number::NumberType;

/// One `<DataArray>`.
#[derive(Debug)]
pub(crate) struct ArrayTag<'a> {
    pub(crate) name: String,
    pub(crate) kind: ArrayKind,
    pub(crate) components: usize,
    pub(crate) source: Source<'a>,
}

/// What an array is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ArrayKind {
    Numbers(NumberType),
    /// Strings or bits, which no field is made of.
    Other,
}

/// Where the values of an array are.
#[derive(Debug)]
pub(crate) enum Source<'a> {
    /// In the element, as numbers in text.
    Ascii(Cow<'a, str>),
    /// In the element, as base64.
    Base64(Cow<'a, str>),
    /// In the appended section, so far behind its underscore.
    Appended(u64),
}
