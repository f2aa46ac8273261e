//! How a run shows its progress on stderr: bars on a terminal, plain lines
//! elsewhere, only remarks when quiet.

use std::io::IsTerminal;
use std::sync::Mutex;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use octruss::progress::News;

/// Shows news of a run.
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

    /// Shows one piece of news of stage `stage` (from 1) of `stages`.
    pub fn show(&self, stage: usize, stages: usize, label: &str, news: News) {
        let head = format!("[{stage}/{stages}] {label}");
        match self {
            Self::Bar(bar) => {
                // A poisoned lock means a panic elsewhere, which is told anyway.
                if let Ok(mut bar) = bar.lock() {
                    show_on_bar(&mut bar, &head, news);
                }
            }
            Self::Lines => {
                if let Some(text) = line(&news) {
                    super::say(&format!("{head}: {text}"));
                }
            }
            Self::Quiet => {
                if let News::Remark(text) = &news {
                    super::say(&remark(text));
                }
            }
        }
    }
}

/// What is left to read of a piece of news; beginnings leave nothing.
fn line(news: &News) -> Option<String> {
    match news {
        News::Started | News::Step { .. } | News::Note(_) => None,
        News::Remark(text) => Some(remark(text)),
        News::Done { what, result, seconds } => Some(format!("{what} … {result}, {seconds:.1} s")),
        News::Finished { summary, seconds } => Some(format!("{summary} ({seconds:.1} s)")),
    }
}

fn remark(text: &str) -> String {
    format!("note: {text}")
}

fn show_on_bar(bar: &mut ProgressBar, head: &str, news: News) {
    match news {
        News::Started => *bar = stage_bar(head),
        News::Step { number, of, what } => {
            bar.set_length(of as u64);
            bar.set_position(number as u64 - 1);
            bar.set_message(what);
        }
        News::Remark(text) => bar.suspend(|| super::say(&format!("{head}: {}", remark(&text)))),
        News::Note(text) => bar.set_message(text),
        News::Done { .. } => bar.inc(1),
        News::Finished { .. } => {
            bar.finish_and_clear();
            if let Some(text) = line(&news) {
                super::say(&format!("{head}: {text}"));
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
