//! News of a run, for whoever wants to show it.

use std::time::Instant;

/// What just happened in a run.
#[derive(Debug, Clone, PartialEq)]
pub enum News {
    /// A stage begins.
    Started,
    /// A step of the stage begins: its number, counted from 1, and its name.
    Step {
        /// From 1.
        number: usize,
        /// How many steps the stage has.
        of: usize,
        /// What is done, such as `level 2 of 3`.
        what: String,
    },
    /// Something that the user should know even if progress is of no interest.
    Remark(String),
    /// Something worth showing while a step runs, such as a residual.
    Note(String),
    /// A step is done.
    Done {
        /// The step's name.
        what: String,
        /// What came of it, such as `1.6 M tets`.
        result: String,
        /// How long it took.
        seconds: f64,
    },
    /// The stage is done.
    Finished {
        /// The stage in a sentence.
        summary: String,
        /// How long it took.
        seconds: f64,
    },
}

/// Who hears the news: the number of the stage (from 1), how many there are,
/// its label, and the news.
pub type Listener<'a> = dyn Fn(usize, usize, &str, News) + Sync + 'a;

/// A stage's line to its listener.
pub struct Progress<'a> {
    /// The stage's number, from 1.
    pub stage: usize,
    /// How many stages the run has.
    pub stages: usize,
    /// The stage's label.
    pub label: &'a str,
    /// Who hears it.
    pub listener: &'a Listener<'a>,
}

impl Progress<'_> {
    /// Passes news on.
    pub fn tell(&self, news: News) {
        (self.listener)(self.stage, self.stages, self.label, news);
    }

    /// Does one step, whose work returns its result and that result in words,
    /// and tells about its begin and its end.
    ///
    /// # Errors
    /// As the work.
    pub fn step<T, E>(
        &self,
        number: usize,
        of: usize,
        what: &str,
        work: impl FnOnce() -> Result<(T, String), E>,
    ) -> Result<T, E> {
        self.tell(News::Step { number, of, what: what.into() });
        let start = Instant::now();
        let (value, result) = work()?;
        let seconds = start.elapsed().as_secs_f64();
        self.tell(News::Done { what: what.into(), result, seconds });
        Ok(value)
    }
}
