//! What a stage is called: by overrides, reports, expectations and errors.

use super::tree::Tree;

/// The label of each stage of an unread list. A stage without a kind is `?`.
pub fn labels_of_trees(stages: &[Tree]) -> Vec<String> {
    let kinds: Vec<&str> = stages.iter().map(|stage| kind(stage).unwrap_or("?")).collect();
    labels(&kinds)
}

fn kind<'t>(stage: &'t Tree) -> Option<&'t str> {
    stage.get_ref().get("kind")?.get_ref().as_str()
}

/// A label for each kind: the kind, with `-2`, `-3` … from its second time on.
pub fn labels(kinds: &[&str]) -> Vec<String> {
    let label = |(index, kind): (usize, &&str)| match kinds[..index]
        .iter()
        .filter(|before| *before == kind)
        .count()
    {
        0 => kind.to_string(),
        before => format!("{kind}-{}", before + 1),
    };
    kinds.iter().enumerate().map(label).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_second_of_a_kind_is_numbered() {
        assert_eq!(super::labels(&["a", "b", "a", "a"]), ["a", "b", "a-2", "a-3"]);
    }
}
