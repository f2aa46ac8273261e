//! What the readers of text share: numbers, places, and pieces of a file as
//! messages show them.

use std::str::FromStr;

/// Parses through the standard library.
pub(crate) fn parse_text<T: FromStr>(token: &[u8]) -> Option<T> {
    std::str::from_utf8(token).ok()?.parse().ok()
}

/// The line that `position` is in, counted from 1.
pub(crate) fn line_at(bytes: &[u8], position: usize) -> usize {
    let before = &bytes[..position.min(bytes.len())];
    1 + before.iter().filter(|&&byte| byte == b'\n').count()
}

/// A piece of the file as a message can show it: short, printable, in quotes.
pub(crate) fn quoted(text: &[u8]) -> String {
    const SHOWN: usize = 40;
    let cut = &text[..text.len().min(SHOWN)];
    let dots = if text.len() > SHOWN { "…" } else { "" };
    format!("\"{}{dots}\"", String::from_utf8_lossy(cut).escape_debug())
}

/// The message of a file that ends before `what`.
pub(crate) fn cut_off(what: &str) -> String {
    format!("the file ends where {what} was expected: it is cut off, write it again")
}

/// Checks a count that a file announces against the `left` bytes that follow
/// (each record takes `least` bytes at least), so that it may size memory. The
/// error is the message of a count that cannot be true.
pub(crate) fn announced(
    count: u64,
    left: usize,
    least: usize,
    what: &str,
) -> Result<usize, String> {
    usize::try_from(count).ok().filter(|&count| count <= left / least.max(1)).ok_or_else(|| {
        format!(
            "{count} {what} are announced, but only {left} bytes follow, \
             too few for them: the count is wrong or the file is cut off"
        )
    })
}
