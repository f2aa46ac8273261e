//! The stages of a config.

use std::ops::Range;

use octruss_base::suggestion::suggestion;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use super::explain::deserialize;
use super::labels::labels_of_trees;
use super::solve_keys::sort_keys;
use super::tree::Tree;
use crate::error::{ConfigError, Source, needs_before};
use crate::stages::{Stage, StageContradiction, Where};

/// Reads every stage, after those before it.
///
/// # Errors
/// Whatever is wrong with a stage, or that one needs another before it.
pub fn read_stages(root: &Tree, source: &Source) -> Result<Vec<Stage>, ConfigError> {
    let list = stage_list(root, source)?;
    let labels = labels_of_trees(list);
    let mut stages: Vec<Stage> = Vec::new();
    for (tree, label) in list.iter().zip(&labels) {
        let stage: Stage = deserialize(by_kind(tree, label, source)?, Some(label), source)?;
        if let Some(needed) = stage.needs()
            && !stages.iter().any(|before| before.kind() == needed)
        {
            let message = needs_before(&format!("stage `{label}`"), needed);
            return Err(source.error(&tree.span(), message));
        }
        if let Some(StageContradiction { place, message }) = stage.contradiction() {
            let message = format!("stage `{label}`: {message}");
            return Err(source.error(&place_of(place, tree), message));
        }
        stages.push(stage);
    }
    Ok(stages)
}

fn stage_list<'t, 'a>(root: &'t Tree<'a>, source: &Source) -> Result<&'t DeArray<'a>, ConfigError> {
    let wrong = |span, found: &str| {
        let message = format!("{found}: every step is a table headed [[stage]] with a `kind`");
        source.error(&span, message)
    };
    let Some(list) = root.get_ref().get("stage") else {
        return Err(wrong(0..0, "the config has no stage"));
    };
    match list.get_ref() {
        DeValue::Array(entries) if entries.is_empty() => {
            Err(wrong(list.span(), "the config has no stage"))
        }
        DeValue::Array(entries) => Ok(entries),
        other => Err(wrong(list.span(), &format!("`stage` is one {}", other.type_str()))),
    }
}

/// Where in the text something is that does not go together.
fn place_of(place: Where, stage: &Tree) -> Range<usize> {
    let key_span = |key: &str| {
        let DeValue::Table(options) = stage.get_ref() else { return None };
        options.keys().find(|given| given.get_ref() == key).map(Spanned::span)
    };
    match place {
        Where::Span(span) => span,
        Where::Key(key) => key_span(key).unwrap_or(stage.span()),
        Where::Stage => stage.span(),
    }
}

/// Turns `{ kind = K, … }` into `{ K = { … } }`, which is how serde spells a
/// choice without losing the places of what is inside.
fn by_kind<'a>(stage: &Tree<'a>, label: &str, source: &Source) -> Result<Tree<'a>, ConfigError> {
    let DeValue::Table(mut options) = stage.get_ref().clone() else {
        return Err(source.error(&stage.span(), "a stage is a table with a `kind`"));
    };
    let kind = options.remove("kind").ok_or_else(|| {
        let message = format!("a stage needs a `kind` (valid: {})", Stage::KINDS.join(", "));
        source.error(&stage.span(), message)
    })?;
    let span = kind.span();
    let DeValue::String(name) = kind.into_inner() else {
        return Err(source.error(&span, "`kind` must be a string"));
    };
    if !Stage::KINDS.contains(&name.as_ref()) {
        let message = format!("unknown kind of stage `{name}`{}", suggestion(&name, &Stage::KINDS));
        return Err(source.error(&span, message));
    }
    if name == "solve" {
        options = sort_keys(options, stage.span(), label, source)?;
    }
    let options = Spanned::new(stage.span(), DeValue::Table(options));
    let choice = DeTable::from_iter([(Spanned::new(span.clone(), name), options)]);
    Ok(Spanned::new(span, DeValue::Table(choice)))
}
