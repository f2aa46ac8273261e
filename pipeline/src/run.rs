//! The run: a loop over stages.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use crate::error::Error;
use crate::observer::{Event, Observer, StagePlace};
use crate::recipe::{Recipe, compare, stage_labels};
use crate::report::{Report, SCHEMA, StageReport};
use crate::stages::{Context, Stage, Workplace};
use crate::state::State;
use crate::{memory, output};

/// Runs a recipe's stages in order, writes `report.json` into `output_folder`
/// (made if missing) and compares the report with what was expected.
///
/// Missed expectations are no error: they are in [`Report::expectations`]. Once
/// `stop` is true, the run ends before the next stage, and a solve after the
/// iteration that it is at.
///
/// # Errors
/// Whatever stops a stage, and then there is no report, not even that of an
/// earlier run, unless it is [`Error::Unfinished`]; an output folder that cannot be
/// written, before anything runs; an expectation of a number that the
/// report does not have, after the report is written.
pub fn run(
    recipe: &Recipe,
    output_folder: &Path,
    observer: &dyn Observer,
    stop: &AtomicBool,
) -> Result<Report, Error> {
    output::check_folder(output_folder)?;
    output::remove_earlier(output_folder)?;
    let start = Instant::now();
    let (input_folder, source) = (&*recipe.folder, Some(&recipe.source));
    let work = Workplace { input_folder, output_folder, source, observer, stop };
    let mut stages = Vec::new();
    let unfinished = match run_into(&mut stages, &recipe.stages, work) {
        Ok(_) => None,
        Err(Error::Unfinished(solve)) => Some(solve),
        Err(error) => return Err(error),
    };
    let mut report = Report {
        schema: SCHEMA,
        octruss: env!("CARGO_PKG_VERSION").into(),
        config: recipe.name.clone(),
        threads: rayon::current_num_threads(),
        seconds: start.elapsed().as_secs_f64(),
        peak_memory_bytes: memory::peak_bytes(),
        stages,
        expectations: Vec::new(),
        unfinished: unfinished.as_deref().cloned(),
    };
    if let Some(solve) = unfinished {
        report.write(output_folder)?;
        return Err(Error::Unfinished(solve));
    }
    let compared = compare(&recipe.expectations, &report);
    report.expectations = compared.as_ref().map_or_else(|_| Vec::new(), Clone::clone);
    report.write(output_folder)?;
    compared?;
    Ok(report)
}

/// Runs stages in order; returns what they made.
///
/// # Errors
/// Whatever stops a stage.
pub fn run_stages(stages: &[Stage], work: Workplace) -> Result<State, Error> {
    run_into(&mut Vec::new(), stages, work)
}

/// As [`run_stages`], until asked to stop; adds to `reports` what each stage did,
/// also where a later one fails.
fn run_into(
    reports: &mut Vec<StageReport>,
    stages: &[Stage],
    work: Workplace,
) -> Result<State, Error> {
    let mut state = State::default();
    for (index, (stage, label)) in stages.iter().zip(stage_labels(stages)).enumerate() {
        let stage_place = StagePlace { number: index + 1, of: stages.len(), label: label.clone() };
        let context = Context { work, stage: stage_place };
        if context.asked_to_stop() {
            return Err(Error::Stopped { stage: label });
        }
        context.tell(Event::StageBegan);
        let start = Instant::now();
        let done = stage.run(&mut state, &context)?;
        let seconds = start.elapsed().as_secs_f64();
        context.tell(Event::StageDone { summary: done.summary(), seconds });
        reports.push(StageReport { name: label, seconds, done });
    }
    Ok(state)
}
