//! Finding where sections start and end.

use super::scanner::{Scanner, quoted};
use crate::Error;

impl Scanner<'_> {
    /// The name of the next section without its `$`, or `None` at the end of the file.
    pub fn section(&mut self) -> Result<Option<String>, Error> {
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
    pub fn end_section(&mut self, name: &str) -> Result<(), Error> {
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
