//! How a run shows its progress on stderr: bars on a terminal, plain lines
//! elsewhere, only remarks when quiet.

use std::io::IsTerminal;
use std::sync::Mutex;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use octruss::observer::{Event, Observer, StagePlace};

use super::say::say;

/// Shows what happens in a run.
pub enum Display {
    /// One bar, for the stage that runs.
    Bar(Mutex<ProgressBar>),
    /// A line for each thing done.
    Lines,
    /// Remarks alone.
    Quiet,
}

impl Display {
    /// Bars if stderr is a terminal, else lines; only remarks if `quiet`.
    pub fn new(quiet: bool) -> Self {
        if quiet {
            Self::Quiet
        } else if std::io::stderr().is_terminal() {
            Self::Bar(Mutex::new(ProgressBar::hidden()))
        } else {
            Self::Lines
        }
    }
}

impl Observer for Display {
    fn hear(&self, stage: &StagePlace, event: &Event) {
        let head = format!("[{}/{}] {}", stage.number, stage.of, stage.label);
        match self {
            Self::Bar(bar) => {
                // A poisoned lock means a panic elsewhere, which is told anyway.
                if let Ok(mut bar) = bar.lock() {
                    show_on_bar(&mut bar, &head, event);
                }
            }
            Self::Lines => {
                if let Some(text) = line(event) {
                    say(&format!("{head}: {text}"));
                }
            }
            Self::Quiet => {
                if let Event::Remark(text) = event {
                    say(&remark(text));
                }
            }
        }
    }
}

/// What is left to read of an event; beginnings leave nothing.
fn line(event: &Event) -> Option<String> {
    match event {
        Event::StageBegan | Event::StepBegan { .. } | Event::Note(_) => None,
        Event::Remark(text) => Some(remark(text)),
        Event::StepDone { what, result, seconds } => {
            Some(format!("{what} … {result}, {seconds:.1} s"))
        }
        Event::StageDone { summary, seconds } => Some(format!("{summary} ({seconds:.1} s)")),
    }
}

fn remark(text: &str) -> String {
    format!("note: {text}")
}

fn show_on_bar(bar: &mut ProgressBar, head: &str, event: &Event) {
    match event {
        Event::StageBegan => *bar = stage_bar(head),
        Event::StepBegan { number, of, what } => {
            bar.set_length(*of as u64);
            bar.set_position(*number as u64 - 1);
            bar.set_message(what.clone());
        }
        Event::Remark(text) => bar.suspend(|| say(&format!("{head}: {}", remark(text)))),
        Event::Note(text) => bar.set_message(text.clone()),
        Event::StepDone { .. } => bar.inc(1),
        Event::StageDone { .. } => {
            bar.finish_and_clear();
            if let Some(text) = line(event) {
                say(&format!("{head}: {text}"));
            }
        }
    }
}

fn stage_bar(head: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(1), ProgressDrawTarget::stderr_with_hz(5));
    let template = "{prefix:18} {bar:24} {pos}/{len} {elapsed} {msg}";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.set_prefix(head.to_string());
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
