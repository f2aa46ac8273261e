//! Lines and the sections that they start and end: text in binary files, too.

use std::str::FromStr;

use super::scanner::Scanner;
use crate::problem::Problem;
use crate::text::{parse_text, quoted};

impl<'a> Scanner<'a> {
    /// The next line without its end and without blanks around it.
    pub fn line(&mut self, what: &str) -> Result<&'a [u8], Problem> {
        let rest = self.rest();
        if rest.is_empty() {
            return Err(self.cut_off(what));
        }
        let end = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        self.advance(end + 1);
        Ok(rest[..end].trim_ascii())
    }

    /// A line that holds one number.
    pub fn number_line<T: FromStr>(&mut self, what: &str) -> Result<T, Problem> {
        let start = self.position();
        let line = self.line(what)?;
        parse_text(line).ok_or_else(|| {
            self.malformed_at(
                start,
                format!("found {} where {what} was expected, one number on a line", quoted(line)),
            )
        })
    }

    /// Skips blank lines.
    pub fn skip_blank(&mut self) {
        let rest = self.rest();
        let blank = rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        self.advance(blank);
    }

    /// Moves behind the next line that is exactly `marker`; binary data may come before it.
    pub fn skip_past_line(&mut self, marker: &str) -> Result<(), Problem> {
        let rest = self.rest();
        let mut from = 0;
        while let Some(found) = rest[from..].iter().position(|&byte| byte == b'$') {
            let at = from + found;
            from = at + 1;
            let starts_line = at == 0 || rest[at - 1] == b'\n';
            if let Some(tail) = rest[at..].strip_prefix(marker.as_bytes())
                && starts_line
                && only_blanks(tail)
            {
                self.advance(at + marker.len());
                return Ok(());
            }
        }
        Err(self.cut_off(&format!("the line {marker}")))
    }

    /// The name of the next section without its `$`, or `None` at the end of the file.
    pub fn section(&mut self) -> Result<Option<String>, Problem> {
        self.skip_blank();
        if self.rest().is_empty() {
            return Ok(None);
        }
        let start = self.position();
        let line = self.line("a section")?;
        match line.strip_prefix(b"$").and_then(|name| std::str::from_utf8(name).ok()) {
            Some(name) if !name.is_empty() && !name.starts_with("End") => Ok(Some(name.into())),
            _ => Err(self.malformed_at(
                start,
                format!("found {} where a section was expected, such as $Nodes", quoted(line)),
            )),
        }
    }

    /// Reads `$EndNAME`.
    pub fn end_section(&mut self, name: &str) -> Result<(), Problem> {
        self.skip_blank();
        let start = self.position();
        let line = self.line(&format!("the end of the section, $End{name},"))?;
        if line.strip_prefix(b"$End") == Some(name.as_bytes()) {
            return Ok(());
        }
        Err(self.malformed_at(
            start,
            format!(
                "found {} where $End{name} was expected: the section holds more than it \
                 announces, or its end is missing",
                quoted(line)
            ),
        ))
    }
}

/// Whether the line that `text` starts with holds blanks only.
fn only_blanks(text: &[u8]) -> bool {
    matches!(text.iter().find(|byte| !matches!(byte, b' ' | b'\t' | b'\r')), None | Some(b'\n'))
}
