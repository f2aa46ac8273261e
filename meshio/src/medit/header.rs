//! How a Medit file begins.

use super::words::Words;
use crate::problem::Problem;
use crate::text::{parse_text, quoted};

/// Reads the first keyword and the version.
pub(super) fn read(words: &mut Words, bytes: &[u8]) -> Result<(), Problem> {
    // Binary files begin with the number one, in either byte order.
    if bytes.starts_with(&[1, 0, 0, 0]) || bytes.starts_with(&[0, 0, 0, 1]) {
        return Err(Problem::unsupported(
            "this is a binary Medit file (.meshb), which is not read; save it as ASCII .mesh",
        ));
    }
    match words.take() {
        Some(word) if word.text.eq_ignore_ascii_case(b"MeshVersionFormatted") => {}
        Some(word) => {
            return Err(words.malformed(
                word.place,
                format!(
                    "not a Medit mesh: found {} where MeshVersionFormatted was expected; save the \
                     mesh as ASCII .mesh",
                    quoted(word.text)
                ),
            ));
        }
        None => return Err(words.cut_off("MeshVersionFormatted")),
    }
    let version = words.number(parse_text::<i64>, "1 to 4", format_args!("the version"))?;
    if (1..=4).contains(&version) {
        return Ok(());
    }
    Err(Problem::unsupported(format!(
        "the Medit file has version {version}, which is not read; save as version 1 to 4"
    )))
}
