//! Building a sparse matrix row by row, in parallel and in place.

use crate::sparse::csr::Csr;
use octruss_base::chunks::{chunk_len, for_chunks};
use octruss_base::large_array::zeroed;
use octruss_base::ragged::Cut;
use rayon::prelude::*;

/// A matrix from the length of each row and a function that fills a row's
/// columns, ascending, and values.
pub fn build_rows<E: Copy + Default + Send>(
    (rows, columns): (usize, usize),
    length: impl Fn(usize) -> usize + Sync,
    fill: impl Fn(usize, &mut [u32], &mut [E]) + Sync,
) -> Csr<E> {
    let offsets = offsets(rows, length);
    let mut indices: Vec<u32> = zeroed(offsets[rows]);
    let mut values: Vec<E> = zeroed(offsets[rows]);
    let entries = (&mut indices[..], &mut values[..]);
    for_rows(
        rows,
        |row| offsets[row],
        entries,
        |row, (indices, values)| {
            fill(row, indices, values);
        },
    );
    Csr::trusted(columns, offsets, indices, values)
}

/// Where each row begins, and the number of entries, from the length of each row.
pub(crate) fn offsets(rows: usize, length: impl Fn(usize) -> usize + Sync) -> Vec<usize> {
    let mut offsets = zeroed(rows + 1);
    for_chunks(&mut offsets[1..], |first, chunk| {
        chunk.iter_mut().enumerate().for_each(|(k, slot)| *slot = length(first + k));
    });
    let mut end = 0;
    for slot in &mut offsets {
        end += *slot;
        *slot = end;
    }
    offsets
}

/// Runs `work(row, entries)` for all rows, with the entries between offset(row) and
/// offset(row + 1).
pub(crate) fn for_rows<V: Cut>(
    rows: usize,
    offset: impl Fn(usize) -> usize + Sync,
    mut entries: V,
    work: impl Fn(usize, V) + Sync,
) {
    // Each chunk of rows gets its own piece.
    let len = chunk_len(rows);
    let mut pieces = Vec::with_capacity(rows.div_ceil(len));
    for first in (0..rows).step_by(len) {
        let last = (first + len).min(rows);
        let piece;
        (piece, entries) = entries.cut(offset(last) - offset(first));
        pieces.push((first..last, piece));
    }
    pieces.into_par_iter().for_each(|(rows, mut entries)| {
        for row in rows {
            let own;
            (own, entries) = entries.cut(offset(row + 1) - offset(row));
            work(row, own);
        }
    });
}
