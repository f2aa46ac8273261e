//! Working on ragged arrays in parallel: each task gets whole rows.

use rayon::prelude::*;

/// Rows a task; large enough that splitting costs nothing.
pub(crate) const CHUNK: usize = 4096;

/// Turns counts, stored from place 1 on, into offsets.
pub(crate) fn accumulate<T: Copy + std::ops::AddAssign>(counts: &mut [T]) {
    for i in 1..counts.len() {
        let before = counts[i - 1];
        counts[i] += before;
    }
}

/// Runs `work(first_row, last_row, values)` for chunks of rows, where row r owns
/// `values[offsets[r]..offsets[r + 1]]` and the task gets the values of its rows.
pub(crate) fn for_each<O: Copy + Sync, T: Send>(
    offsets: &[O],
    values: &mut [T],
    work: impl Fn(usize, usize, &mut [T]) + Sync,
) where
    u64: From<O>,
{
    let rows = offsets.len() - 1;
    let at = |row: usize| u64::from(offsets[row]) as usize;
    let mut rest = &mut values[at(0)..];
    let mut tasks = Vec::with_capacity(rows / CHUNK + 1);
    for first in (0..rows).step_by(CHUNK) {
        let last = (first + CHUNK).min(rows);
        let (chunk, tail) = rest.split_at_mut(at(last) - at(first));
        rest = tail;
        tasks.push((first, last, chunk));
    }
    tasks.into_par_iter().for_each(|(first, last, chunk)| work(first, last, chunk));
}
