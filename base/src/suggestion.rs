//! The name that a user most likely meant.

/// The candidate closest to `word` by edit distance, if it is close enough to
/// be a slip of the fingers: at most a third of the letters differ, or one.
pub fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let allowed = (word.chars().count() / 3).max(1);
    candidates
        .iter()
        .map(|&candidate| (strsim::damerau_levenshtein(word, candidate), candidate))
        .filter(|&(distance, _)| distance <= allowed)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// The end of a message about an unknown name: `; did you mean …? (valid: …)`.
pub fn suggestion(word: &str, valid: &[&str]) -> String {
    let guess = nearest(word, valid)
        .map_or_else(String::new, |candidate| format!("; did you mean `{candidate}`?"));
    format!("{guess} (valid: {})", valid.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_recognised_and_a_different_word_is_not() {
        let names = ["scheme", "levels", "crease-angle"];
        assert_eq!(nearest("levles", &names), Some("levels"));
        assert_eq!(nearest("crease_angle", &names), Some("crease-angle"));
        assert_eq!(nearest("colour", &names), None);
        assert_eq!(
            suggestion("levles", &names),
            "; did you mean `levels`? (valid: scheme, levels, crease-angle)"
        );
    }
}
