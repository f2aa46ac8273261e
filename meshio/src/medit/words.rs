//! The words of a Medit file: what blanks and line ends separate, comments left out.

use std::fmt::Arguments;

use crate::error::Place;
use crate::problem::Problem;
use crate::text::{self, line_at, parse_text, quoted};

/// A cursor over the words of a file.
pub(super) struct Words<'a> {
    bytes: &'a [u8],
    position: usize,
}

/// A word of the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Word<'a> {
    pub(super) text: &'a [u8],
    /// Its first byte in the file.
    pub(super) place: usize,
}

/// A keyword with a count behind it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section {
    pub(super) keyword: &'static str,
    pub(super) count: usize,
}

impl<'a> Words<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, position: 0 }
    }

    /// The content is wrong at `place`.
    #[cold]
    pub(super) fn malformed(&self, place: usize, message: impl Into<String>) -> Problem {
        Problem::Malformed(Place::Line(line_at(self.bytes, place)), message.into())
    }

    /// The file ends before `what`.
    #[cold]
    pub(super) fn cut_off(&self, what: &str) -> Problem {
        self.malformed(self.bytes.len(), text::cut_off(what))
    }

    /// The next word, which stays the next one; `None` at the end of the file.
    pub(super) fn peek(&mut self) -> Option<Word<'a>> {
        loop {
            let rest = &self.bytes[self.position..];
            self.position += rest.iter().take_while(|&&byte| byte <= b' ').count();
            let rest = &self.bytes[self.position..];
            let end = match rest.first()? {
                b'#' => {
                    let line = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
                    self.position += line;
                    continue;
                }
                _ => rest.iter().position(|&byte| byte <= b' ' || byte == b'#'),
            };
            let text = &rest[..end.unwrap_or(rest.len())];
            return Some(Word { text, place: self.position });
        }
    }

    /// The next word; the cursor moves behind it.
    pub(super) fn take(&mut self) -> Option<Word<'a>> {
        let word = self.peek()?;
        self.position += word.text.len();
        Some(word)
    }

    /// A number that `parse` understands.
    pub(super) fn number<T>(
        &mut self,
        parse: impl Fn(&[u8]) -> Option<T>,
        kind: &str,
        what: Arguments<'_>,
    ) -> Result<T, Problem> {
        let Some(word) = self.take() else {
            return Err(self.cut_off(&format!("{what} ({kind})")));
        };
        parse(word.text).ok_or_else(|| {
            let found = quoted(word.text);
            self.malformed(word.place, format!("found {found} where {what} was expected, {kind}"))
        })
    }

    /// A floating-point number; "nan" and "inf" are numbers here.
    pub(super) fn double(&mut self, what: Arguments<'_>) -> Result<f64, Problem> {
        self.number(parse_double, "a number", what)
    }

    /// The count behind `keyword`, checked against the bytes that are left: an
    /// entry has so many words.
    pub(super) fn section(
        &mut self,
        keyword: &'static str,
        words: usize,
    ) -> Result<Section, Problem> {
        let place = self.peek().map_or(self.position, |word| word.place);
        let (kind, what) = ("a whole number, 0 or more", format_args!("the number of {keyword}"));
        let count = self.number(parse_text::<u64>, kind, what)?;
        // A word has one character and a blank before it.
        let left = self.bytes.len() - self.position;
        let count = text::announced(count, left, 2 * words, keyword)
            .map_err(|message| self.malformed(place, message))?;
        Ok(Section { keyword, count })
    }

    /// Passes over the numbers up to the next keyword; returns how many there were.
    pub(super) fn skip_numbers(&mut self) -> usize {
        let mut skipped = 0;
        while let Some(word) = self.peek()
            && !is_keyword(word.text)
        {
            self.position += word.text.len();
            skipped += 1;
        }
        skipped
    }
}

/// Whether a word is made like a keyword, and is no number.
pub(super) fn is_keyword(word: &[u8]) -> bool {
    word.first().is_some_and(u8::is_ascii_alphabetic)
        && word.iter().all(u8::is_ascii_alphanumeric)
        && parse_double(word).is_none()
}

/// A number, perhaps with an exponent of Fortran's, as in 1.5D+02.
fn parse_double(word: &[u8]) -> Option<f64> {
    parse_text(word).or_else(|| {
        let exponent = word.iter().position(|byte| matches!(byte, b'd' | b'D'))?;
        let mut word = word.to_vec();
        word[exponent] = b'e';
        parse_text(&word)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_line_ends_separate_words() {
        let mut words = Words::new(b"# a file\r\nVertices#two\n\t2\n#end");
        let texts: Vec<_> = std::iter::from_fn(|| words.take()).map(|word| word.text).collect();
        assert_eq!(texts, [&b"Vertices"[..], b"2"]);
    }

    #[test]
    fn numbers_with_exponents_of_c_and_of_fortran() {
        for (word, value) in
            [("1.5D+02", Some(150.0)), ("-2d0", Some(-2.0)), ("3e-1", Some(0.3)), ("1d", None)]
        {
            assert_eq!(parse_double(word.as_bytes()), value, "{word}");
        }
        assert!(is_keyword(b"End") && is_keyword(b"d1") && !is_keyword(b"inf"));
    }
}
