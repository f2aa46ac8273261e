//! Results to stdout, everything else to stderr.

use std::io::{self, Write};

/// Prints a result. A reader that has gone away (`octruss info part.msh | head`)
/// is no failure.
pub fn print(text: &str) -> anyhow::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// Prints a message. Where stderr is closed there is nobody to tell.
pub fn say(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Prints an error; our messages contain those of their sources.
pub fn say_error(error: &anyhow::Error) {
    say(&format!("error: {error}"));
}
