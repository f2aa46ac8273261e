//! Building a sparse matrix row by row, in parallel and in place.

use crate::chunks::map_ranges;
use crate::csr::Csr;
use rayon::prelude::*;

/// A matrix from the length of each row and a function that fills a row's
/// columns, ascending, and values.
pub(crate) fn build_rows<E: Copy + Default + Send>(
    (rows, columns): (usize, usize),
    length: impl Fn(usize) -> usize + Sync,
    fill: impl Fn(usize, &mut [u32], &mut [E]) + Sync,
) -> Csr<E> {
    let lengths = map_ranges(rows, |range| range.map(&length).collect::<Vec<_>>());
    let mut offsets = Vec::with_capacity(rows + 1);
    offsets.push(0);
    let mut end = 0;
    for length in lengths.iter().flatten() {
        end += length;
        offsets.push(end);
    }
    let mut indices = vec![0u32; end];
    let mut values = vec![E::default(); end];
    // Each chunk of rows gets its own piece of the two arrays.
    let (mut indices_left, mut values_left) = (&mut indices[..], &mut values[..]);
    let mut pieces = Vec::with_capacity(lengths.len());
    let mut first = 0;
    for chunk in &lengths {
        let entries = offsets[first + chunk.len()] - offsets[first];
        let (piece_indices, piece_values);
        (piece_indices, indices_left) = indices_left.split_at_mut(entries);
        (piece_values, values_left) = values_left.split_at_mut(entries);
        pieces.push((first, piece_indices, piece_values));
        first += chunk.len();
    }
    pieces.into_par_iter().zip(&lengths).for_each(|((first, indices, values), chunk)| {
        let mut at = 0;
        for (k, length) in chunk.iter().enumerate() {
            fill(first + k, &mut indices[at..at + length], &mut values[at..at + length]);
            at += length;
        }
    });
    Csr::trusted(columns, offsets, indices, values)
}
