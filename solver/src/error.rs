//! Everything that can go wrong in this crate.

use crate::report::Unfinished;
use octruss_base::chunks::map_ranges;

/// Why a system could not be set up or solved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The three arrays do not form a sparse matrix.
    #[error("malformed sparse matrix, row {row}: {what}")]
    Malformed {
        /// The first row at fault.
        row: usize,
        /// What must hold and does not.
        what: &'static str,
    },
    /// Two things that belong together have different sizes.
    #[error("{what}: found {found}, expected {expected}")]
    Size {
        /// Which number of what.
        what: &'static str,
        /// The size given.
        found: usize,
        /// The size that fits.
        expected: usize,
    },
    /// A multigrid was to take the numbers of a matrix with other entries.
    #[error(
        "the matrix has entries elsewhere than the one that the multigrid was built from: \
         build a new one"
    )]
    Pattern,
    /// An option has a value that makes no sense.
    #[error("option `{option}`: {expected}")]
    Option {
        /// The option's name.
        option: &'static str,
        /// What it must satisfy.
        expected: &'static str,
    },
    /// A matrix or vector holds an infinity or a NaN.
    #[error("{what}, entry {index} is {value}; all numbers must be finite")]
    NotFinite {
        /// Which array.
        what: &'static str,
        /// The first entry at fault; for a matrix counted row by row.
        index: usize,
        /// The value found.
        value: f64,
    },
    /// A level's diagonal is missing or not positive.
    #[error("level {level}, row {row}: the diagonal is {value}; it must be positive")]
    Diagonal {
        /// 0 is the coarsest.
        level: usize,
        /// The first row at fault.
        row: usize,
        /// The value found, 0 where nothing is stored; of a block the first pivot
        /// that is not positive.
        value: f64,
    },
    /// A projector of a constrained row is none, or not in its place.
    #[error("level {level}, row {row}: expected symmetric projectors (Q Q = Q) at ascending rows")]
    Projector {
        /// 0 is the coarsest.
        level: usize,
        /// The first row at fault.
        row: u32,
    },
    /// The coarsest level is too large for a direct solver, and levels below it hardly shrink.
    #[error(
        "the coarsest level has {unknowns} unknowns, a direct solver should get at most {limit}, \
         and its rows are coupled too weakly for smaller levels; refine a coarser mesh instead"
    )]
    CoarsestTooLarge {
        /// Unknowns on the coarsest level.
        unknowns: usize,
        /// The most that are accepted.
        limit: usize,
    },
    /// Neither Cholesky nor LU factors of the coarsest matrix pass their test.
    #[error(
        "the coarsest matrix ({unknowns} unknowns) cannot be factored: Cholesky: {cholesky}; \
         LU: {lu}; it is singular or nearly so: check that enough is fixed on every part"
    )]
    CoarsestSingular {
        /// Unknowns on the coarsest level.
        unknowns: usize,
        /// What Cholesky said, or how its factor failed the test.
        cholesky: Box<str>,
        /// What LU said, or how its factor failed the test.
        lu: Box<str>,
        /// A vector that the matrix sends to zero but for rounding, brought to the finest
        /// level: a number, or three, for each of its rows. Empty if none was found.
        null_vector: Vec<f64>,
    },
    /// A direction p with p · A p ≤ 0 was met, or a preconditioner that is not
    /// positive.
    #[error(
        "the {what} is not positive definite (iteration {}): check that coefficients are \
         positive and enough is fixed; if they are, try another smoother or double precision \
         in the cycle",
        .at.report.iterations
    )]
    NotPositiveDefinite {
        /// The matrix or the preconditioner.
        what: &'static str,
        /// What was reached.
        at: Box<Unfinished>,
    },
    /// The iteration limit was reached.
    #[error(
        "no convergence: relative residual {:.3e} after {} iterations{}",
        .0.report.relative_residual, .0.report.iterations, rounding(.0)
    )]
    NotConverged(Box<Unfinished>),
    /// The progress callback asked to stop.
    #[error(
        "stopped on request after {} iterations at a relative residual of {:.3e}",
        .0.report.iterations, .0.report.relative_residual
    )]
    Stopped(Box<Unfinished>),
}

/// What to say where the residual of the recurrence goes on falling and the true one
/// does not.
fn rounding(at: &Unfinished) -> &'static str {
    let recurrence = at.report.residual_history.last();
    match recurrence.is_some_and(|last| *last < 0.5 * at.report.relative_residual) {
        true => "; rounding allows no more, so the tolerance is too small for this system",
        false => "",
    }
}

impl Error {
    /// What an iteration left behind that did not reach its goal, if this is about one.
    pub fn unfinished(&self) -> Option<&Unfinished> {
        match self {
            Self::NotPositiveDefinite { at, .. } | Self::NotConverged(at) | Self::Stopped(at) => {
                Some(at)
            }
            _ => None,
        }
    }

    /// The same, for whoever solved for something else in place of the iterate.
    pub fn unfinished_mut(&mut self) -> Option<&mut Unfinished> {
        match self {
            Self::NotPositiveDefinite { at, .. } | Self::NotConverged(at) | Self::Stopped(at) => {
                Some(at)
            }
            _ => None,
        }
    }
}

/// Checks that all of `values` are finite; `what` says which numbers these are.
///
/// # Errors
/// [`Error::NotFinite`] with the first that is not.
pub fn check_finite<T: Copy + Into<f64> + Sync>(
    what: &'static str,
    values: &[T],
) -> Result<(), Error> {
    let first_bad = |range: std::ops::Range<usize>| {
        let start = range.start;
        values[range].iter().position(|&v| !v.into().is_finite()).map(|at| start + at)
    };
    match map_ranges(values.len(), first_bad).into_iter().flatten().next() {
        Some(index) => Err(Error::NotFinite { what, index, value: values[index].into() }),
        None => Ok(()),
    }
}

/// Checks that a size is the one that fits; `what` says of what.
///
/// # Errors
/// [`Error::Size`] if it is not.
pub fn check_size(what: &'static str, found: usize, expected: usize) -> Result<(), Error> {
    if found == expected { Ok(()) } else { Err(Error::Size { what, found, expected }) }
}
