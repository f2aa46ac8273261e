//! Working on ragged arrays in parallel: each task gets whole rows.

use rayon::prelude::*;

use crate::large_array::zeroed;

/// Rows a task; large enough that splitting costs nothing.
pub const CHUNK: usize = 1024;

/// Turns counts, stored from place 1 on, into offsets.
pub fn accumulate<T: Copy + std::ops::AddAssign>(counts: &mut [T]) {
    for i in 1..counts.len() {
        let before = counts[i - 1];
        counts[i] += before;
    }
}

/// Where each row starts in an array of all rows' entries, and their number at
/// the end, from how many each row has.
pub fn offsets(rows: usize, count: impl Fn(usize) -> usize + Sync) -> Vec<u32> {
    let mut offsets = zeroed(rows + 1);
    let counts = offsets[1..].par_iter_mut().with_min_len(CHUNK).enumerate();
    counts.for_each(|(row, slot)| *slot = count(row) as u32);
    accumulate(&mut offsets);
    offsets
}

/// Arrays that are cut at the same places: one, or several side by side.
pub trait Cut: Send + Sized {
    /// The first `count` entries of each, and the rest.
    fn cut(self, count: usize) -> (Self, Self);
}

impl<T: Send> Cut for &mut [T] {
    fn cut(self, count: usize) -> (Self, Self) {
        self.split_at_mut(count)
    }
}

impl<A: Cut, B: Cut> Cut for (A, B) {
    fn cut(self, count: usize) -> (Self, Self) {
        let ((a, a_rest), (b, b_rest)) = (self.0.cut(count), self.1.cut(count));
        ((a, b), (a_rest, b_rest))
    }
}

impl<A: Cut, B: Cut, C: Cut> Cut for (A, B, C) {
    fn cut(self, count: usize) -> (Self, Self) {
        let ((a, a_rest), (b, b_rest)) = (self.0.cut(count), self.1.cut(count));
        let (c, c_rest) = self.2.cut(count);
        ((a, b, c), (a_rest, b_rest, c_rest))
    }
}

/// Runs `work(first_row, last_row, values)` for chunks of rows, where row r owns
/// `values[offsets[r]..offsets[r + 1]]` (of each array, if there are several)
/// and the task gets the values of its rows.
pub fn for_each<O: Copy + Sync, V: Cut>(
    offsets: &[O],
    values: V,
    work: impl Fn(usize, usize, V) + Sync,
) where
    u64: From<O>,
{
    let rows = offsets.len() - 1;
    let at = |row: usize| u64::from(offsets[row]) as usize;
    let (_, mut rest) = values.cut(at(0));
    let mut tasks = Vec::with_capacity(rows / CHUNK + 1);
    for first in (0..rows).step_by(CHUNK) {
        let last = (first + CHUNK).min(rows);
        let (chunk, tail) = rest.cut(at(last) - at(first));
        rest = tail;
        tasks.push((first, last, chunk));
    }
    tasks.into_par_iter().for_each(|(first, last, chunk)| work(first, last, chunk));
}
