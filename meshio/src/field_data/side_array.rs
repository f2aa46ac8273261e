//! Named arrays that belong to a file as a whole.

use std::borrow::Cow;

use crate::problem::Problem;

/// How our own arrays' names start.
pub(crate) const PREFIX: &str = "octruss:";

/// An array to be written.
pub(crate) struct SideArray<'a> {
    /// Behind the prefix.
    pub(crate) name: &'static str,
    pub(crate) components: usize,
    pub(crate) content: SideContent<'a>,
}

/// What it holds.
pub(crate) enum SideContent<'a> {
    /// Vertex numbers, or other words of 32 bits.
    Vertices(Cow<'a, [u32]>),
    /// Group ids or dimensions.
    Ids(Cow<'a, [i32]>),
    /// Small codes; or names in UTF-8, each ended by a zero byte: not VTK's own
    /// strings, which meshio cannot read.
    Bytes(Vec<u8>),
}

/// Where the arrays of a file are looked up, by the name behind the prefix.
pub(crate) trait SideArrays {
    /// The vertex numbers in an array, which has `components` a tuple; `None`
    /// if there is no such array.
    fn vertices(&self, name: &str, components: usize) -> Result<Option<Vec<u32>>, Problem>;
    /// The ids in an array.
    fn ids(&self, name: &str) -> Result<Option<Vec<i32>>, Problem>;
    /// The bytes in an array.
    fn bytes(&self, name: &str) -> Result<Option<Vec<u8>>, Problem>;
}

/// What is wrong with one of our own arrays.
pub(crate) fn wrong(name: &str, message: impl Into<String>) -> Problem {
    Problem::part(format!("array `{PREFIX}{name}`"), message)
}
