//! Grouping by a small integer key, in parallel and the same for any number of
//! threads: count, place, then sort inside each bucket.
//!
//! The order in which threads place entries does not matter, since every
//! bucket is sorted at the end and no two entries are equal.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use rayon::prelude::*;

use crate::chunks::{self, CHUNK};

/// One entry: the bucket that it goes to, its key there, and what to remember.
/// (key, payload) pairs are unique in a bucket.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry {
    pub bucket: u32,
    pub key: u32,
    pub payload: u32,
}

/// First pass: how many entries each bucket will get.
pub(crate) struct Counting {
    counts: Vec<AtomicU32>,
}

/// Second pass: entries go to their buckets.
pub(crate) struct Placing {
    offsets: Vec<u32>,
    cursors: Vec<AtomicU32>,
    entries: Vec<AtomicPair>,
}

/// Entries grouped by bucket, ascending by (key, payload) in each.
pub(crate) struct Buckets {
    offsets: Vec<u32>,
    entries: Vec<Pair>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Pair {
    pub key: u32,
    pub payload: u32,
}

struct AtomicPair {
    key: AtomicU32,
    payload: AtomicU32,
}

impl Counting {
    pub fn new(buckets: usize) -> Self {
        Self { counts: atomics(buckets + 1) }
    }

    /// Counts the N buckets that each of `sources` sources names.
    pub fn count<const N: usize>(
        self,
        sources: usize,
        buckets: impl Fn(usize) -> [u32; N] + Sync,
    ) -> Self {
        (0..sources).into_par_iter().with_min_len(CHUNK).for_each(|source| {
            for bucket in buckets(source) {
                self.counts[bucket as usize + 1].fetch_add(1, Relaxed);
            }
        });
        self
    }

    pub fn place(self) -> Placing {
        let mut offsets: Vec<u32> = self.counts.into_iter().map(AtomicU32::into_inner).collect();
        chunks::accumulate(&mut offsets);
        let total = *offsets.last().expect("one more offset than buckets") as usize;
        let cursors = offsets.par_iter().map(|&offset| AtomicU32::new(offset)).collect();
        let entries = (0..total)
            .into_par_iter()
            .map(|_| AtomicPair { key: AtomicU32::new(0), payload: AtomicU32::new(0) })
            .collect();
        Placing { offsets, cursors, entries }
    }
}

impl Placing {
    /// Places the N entries of each source, in the buckets that it was counted for.
    pub fn place<const N: usize>(
        self,
        sources: usize,
        entries: impl Fn(usize) -> [Entry; N] + Sync,
    ) -> Self {
        (0..sources).into_par_iter().with_min_len(CHUNK).for_each(|source| {
            for Entry { bucket, key, payload } in entries(source) {
                let at = self.cursors[bucket as usize].fetch_add(1, Relaxed) as usize;
                self.entries[at].key.store(key, Relaxed);
                self.entries[at].payload.store(payload, Relaxed);
            }
        });
        self
    }

    pub fn sort(self) -> Buckets {
        let mut entries: Vec<Pair> = self
            .entries
            .into_par_iter()
            .map(|pair| Pair { key: pair.key.into_inner(), payload: pair.payload.into_inner() })
            .collect();
        let offsets = self.offsets;
        chunks::for_each(&offsets, &mut entries, |first, last, chunk| {
            let base = offsets[first] as usize;
            for bucket in first..last {
                let [start, end] = [bucket, bucket + 1].map(|b| offsets[b] as usize - base);
                chunk[start..end].sort_unstable();
            }
        });
        Buckets { offsets, entries }
    }
}

impl Buckets {
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    pub fn bucket(&self, bucket: usize) -> &[Pair] {
        &self.entries[self.offsets[bucket] as usize..self.offsets[bucket + 1] as usize]
    }

    fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The runs of equal keys in one bucket.
    fn runs(&self, bucket: usize) -> impl Iterator<Item = &[Pair]> {
        self.bucket(bucket).chunk_by(|a, b| a.key == b.key)
    }

    /// Where the distinct (bucket, key) pairs of each bucket start when all are
    /// numbered in ascending order; one more offset than buckets.
    pub fn distinct_offsets(&self) -> Vec<u32> {
        let mut offsets = vec![0; self.len() + 1];
        offsets[1..].par_iter_mut().with_min_len(CHUNK).enumerate().for_each(|(bucket, count)| {
            *count = self.runs(bucket).count() as u32;
        });
        chunks::accumulate(&mut offsets);
        offsets
    }

    /// One value for each distinct (bucket, key) pair, in ascending order, made
    /// from the bucket and the run of entries that share the key.
    pub fn map_distinct<T: Send + Copy + Default>(
        &self,
        distinct_offsets: &[u32],
        value: impl Fn(u32, &[Pair]) -> T + Sync,
    ) -> Vec<T> {
        let mut values = vec![T::default(); *distinct_offsets.last().expect("not empty") as usize];
        chunks::for_each(distinct_offsets, &mut values, |first, last, chunk| {
            let mut slots = chunk.iter_mut();
            for bucket in first..last {
                for (run, slot) in self.runs(bucket).zip(&mut slots) {
                    *slot = value(bucket as u32, run);
                }
            }
        });
        values
    }

    /// The number of the distinct pair that each payload belongs to; payloads
    /// are 0 to `payloads` − 1, those that never occurred get `u32::MAX`.
    pub fn number_payloads(&self, distinct_offsets: &[u32], payloads: usize) -> Vec<u32> {
        let numbers: Vec<AtomicU32> =
            (0..payloads).into_par_iter().map(|_| AtomicU32::new(u32::MAX)).collect();
        (0..self.len()).into_par_iter().with_min_len(CHUNK).for_each(|bucket| {
            for (number, run) in (distinct_offsets[bucket]..).zip(self.runs(bucket)) {
                for pair in run {
                    numbers[pair.payload as usize].store(number, Relaxed);
                }
            }
        });
        numbers.into_par_iter().map(AtomicU32::into_inner).collect()
    }
}

fn atomics(n: usize) -> Vec<AtomicU32> {
    (0..n).into_par_iter().map(|_| AtomicU32::new(0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_grouped_sorted_and_numbered() {
        let list = [(2, 9, 0), (0, 5, 1), (2, 3, 2), (0, 5, 3), (2, 9, 4)];
        let entry = |i: usize| {
            let (bucket, key, payload) = list[i];
            [Entry { bucket, key, payload }]
        };
        let buckets = Counting::new(3)
            .count(list.len(), |i| [list[i].0])
            .place()
            .place(list.len(), entry)
            .sort();
        assert_eq!(buckets.offsets(), [0, 2, 2, 5]);
        let payloads: Vec<u32> = buckets.bucket(2).iter().map(|pair| pair.payload).collect();
        assert_eq!(payloads, [2, 0, 4]);
        let distinct = buckets.distinct_offsets();
        assert_eq!(distinct, [0, 1, 1, 3]);
        assert_eq!(
            buckets.map_distinct(&distinct, |b, run| (b, run[0].key)),
            [(0, 5), (2, 3), (2, 9)]
        );
        assert_eq!(buckets.number_payloads(&distinct, 6), [2, 0, 1, 0, 2, u32::MAX]);
    }
}
