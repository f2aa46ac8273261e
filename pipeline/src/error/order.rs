//! The message about a stage that stands too early.

/// That `who` needs a stage of a kind before it.
pub fn needs_before(who: &str, kind: &str) -> String {
    format!("{who} needs a stage `{kind}` before it")
}
