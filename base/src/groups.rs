//! Grouping by a small integer key, in parallel and the same for any number of
//! threads.
//!
//! Two stable counting passes: first into *blocks* of consecutive keys, few
//! enough that each chunk of sources writes to all of them in turn without
//! leaving the cache; then, block by block, to the keys. No atomics, no hashing,
//! no comparisons; entries of one key keep the order of their sources.

use rayon::prelude::*;
use std::slice::IterMut;

use crate::large_array::zeroed;
use crate::ragged;

/// Entries grouped by key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Groups<E> {
    offsets: Vec<u32>,
    entries: Vec<E>,
}

/// The most blocks; as many streams still fit the first-level cache.
const BLOCKS: usize = 512;

impl<E: Copy + Default + Send + Sync> Groups<E> {
    /// Groups what `emit` gives for each of the sources 0 to `sources` − 1:
    /// pairs of a key below `keys` and an entry.
    ///
    /// # Panics
    /// If a key is too large, or there are 2³² entries or more.
    pub fn new<I: IntoIterator<Item = (u32, E)>>(
        keys: usize,
        sources: usize,
        emit: impl Fn(usize) -> I + Sync,
    ) -> Self {
        let width = keys.div_ceil(BLOCKS).next_power_of_two().max(64);
        let (shift, blocks) = (width.trailing_zeros(), keys.div_ceil(width));
        let size = chunk_size(sources);
        let sources_of = |chunk: usize| size * chunk..sources.min(size * (chunk + 1));
        let counts: Vec<Vec<usize>> = (0..sources.div_ceil(size))
            .into_par_iter()
            .map(|chunk| {
                let mut counts = vec![0; blocks];
                // Two loops, here and below: a flat map costs a fifth of the time.
                for source in sources_of(chunk) {
                    for (key, _) in emit(source) {
                        counts[(key >> shift) as usize] += 1;
                    }
                }
                counts
            })
            .collect();
        let sizes: Vec<usize> =
            (0..blocks).map(|block| counts.iter().map(|chunk| chunk[block]).sum()).collect();
        let mut staged: Vec<(u32, E)> = zeroed(sizes.iter().sum());
        pieces(&mut staged, blocks, &counts).into_par_iter().enumerate().for_each(
            |(chunk, mut pieces)| {
                for source in sources_of(chunk) {
                    for (key, entry) in emit(source) {
                        let place = pieces[(key >> shift) as usize].next();
                        *place.expect("its entries were counted") = (key, entry);
                    }
                }
            },
        );
        Self::from_blocks(keys, width, &sizes, &staged)
    }

    /// The second pass: each block's entries to their keys.
    fn from_blocks(keys: usize, width: usize, sizes: &[usize], staged: &[(u32, E)]) -> Self {
        assert!(u32::try_from(staged.len()).is_ok(), "entries are numbered in 32 bits");
        let mut offsets = vec![0; keys + 1];
        let mut entries: Vec<E> = zeroed(staged.len());
        let mut blocks = Vec::with_capacity(sizes.len());
        let (mut staged_left, mut entries_left, mut start) = (staged, &mut entries[..], 0);
        for ((block, &size), ends) in sizes.iter().enumerate().zip(offsets[1..].chunks_mut(width)) {
            let (staged, entries);
            (staged, staged_left) = staged_left.split_at(size);
            (entries, entries_left) = entries_left.split_at_mut(size);
            blocks.push((block * width, start, ends, staged, entries));
            start += size as u32;
        }
        blocks.into_par_iter().for_each(|(first_key, start, ends, staged, entries)| {
            let mut next = vec![0; ends.len() + 1];
            for (key, _) in staged {
                next[*key as usize - first_key + 1] += 1;
            }
            ragged::accumulate(&mut next);
            for (end, &next) in ends.iter_mut().zip(&next[1..]) {
                *end = start + next;
            }
            for &(key, entry) in staged {
                let at = &mut next[key as usize - first_key];
                entries[*at as usize] = entry;
                *at += 1;
            }
        });
        Self { offsets, entries }
    }

    /// Sorts the entries of each key.
    pub fn sort(mut self) -> Self
    where
        E: Ord,
    {
        let offsets = &self.offsets;
        ragged::for_each(offsets, &mut self.entries[..], |first, last, chunk| {
            let base = offsets[first] as usize;
            for key in first..last {
                let [start, end] = [key, key + 1].map(|key| offsets[key] as usize - base);
                chunk[start..end].sort_unstable();
            }
        });
        self
    }
}

impl<E> Groups<E> {
    /// The entries of one key.
    pub fn of(&self, key: usize) -> &[E] {
        &self.entries[self.offsets[key] as usize..self.offsets[key + 1] as usize]
    }

    /// How many keys there are.
    pub fn keys(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Where the entries of each key start; one more offset than keys.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// The runs of neighbouring equal entries of one key, in the sense of `same`.
    pub fn runs(&self, key: usize, same: impl Fn(&E, &E) -> bool) -> impl Iterator<Item = &[E]> {
        self.of(key).chunk_by(same)
    }
}

/// How many sources a chunk has: enough chunks for balance, few enough for their
/// counts to cost nothing; by the number of sources alone, never by that of
/// threads.
fn chunk_size(sources: usize) -> usize {
    (sources / 64).clamp(1 << 12, 1 << 16)
}

/// The part of `staged` that each chunk writes of each block, where blocks
/// follow each other and within a block the chunks do.
fn pieces<'a, T>(
    staged: &'a mut [T],
    blocks: usize,
    counts: &[Vec<usize>],
) -> Vec<Vec<IterMut<'a, T>>> {
    let mut pieces: Vec<Vec<IterMut<T>>> =
        counts.iter().map(|_| Vec::with_capacity(blocks)).collect();
    let mut rest = staged;
    for block in 0..blocks {
        for (chunk, counts) in pieces.iter_mut().zip(counts) {
            let (piece, tail) = rest.split_at_mut(counts[block]);
            chunk.push(piece.iter_mut());
            rest = tail;
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_grouped_in_the_order_of_their_sources() {
        for (keys, sources) in [(1, 0), (3, 5), (1000, 100_000), (200_000, 150_000)] {
            let key = |source: usize| (source * 7919 % 104_729 % keys) as u32;
            let emit = |source: usize| {
                let twice = usize::from(source.is_multiple_of(3));
                [(key(source), source as u32), (key(source + 1), 7)].into_iter().take(1 + twice)
            };
            let groups = Groups::new(keys, sources, emit);
            let mut slow = vec![Vec::new(); keys];
            for (key, entry) in (0..sources).flat_map(emit) {
                slow[key as usize].push(entry);
            }
            assert_eq!(groups.keys(), keys);
            for key in 0..keys {
                assert_eq!(groups.of(key), slow[key]);
            }
            let counts = slow.iter().map(Vec::len).sum::<usize>();
            assert_eq!(*groups.offsets().last().unwrap() as usize, counts);
            let sorted = groups.sort();
            slow.iter_mut().for_each(|entries| entries.sort_unstable());
            assert!((0..keys).all(|key| sorted.of(key) == slow[key]));
        }
    }
}
