//! Adding element contributions to shared targets, in parallel and with the
//! same bits for any number of threads.
//!
//! The elements are cut into fixed chunks. A target belongs to the first chunk
//! that touches it; that chunk alone adds to it directly, in element order.
//! What other chunks contribute goes to lists, which the owner adds afterwards in
//! chunk order. Neighbouring elements share most targets, so the lists are short.
//! Sums lie owner by owner: each chunk has a stretch of memory to itself.

use crate::chunks::{chunk_len, for_chunks, map_ranges};
use octruss_mesh::large_array::{self, zeroed};
use rayon::prelude::*;
use std::sync::atomic::{AtomicU8, Ordering::Relaxed};

/// Enough to balance the load, few enough for their numbers to fit a byte.
const CHUNKS: usize = 64;

/// Which chunk of elements owns each target, for elements with `N` targets.
pub(crate) struct Scatter<'a, const N: usize> {
    elements: &'a [[u32; N]],
    /// Where the sum of each target is.
    places: Vec<u32>,
    /// The first place of each chunk, then that of targets that none touches, then
    /// the number of targets.
    starts: [u32; CHUNKS + 2],
}

/// A sum of `K` numbers for each target.
pub(crate) struct Sums<'a, const K: usize> {
    places: &'a [u32],
    sums: Vec<[f64; K]>,
}

impl<const K: usize> Sums<'_, K> {
    /// The sum at a target.
    #[inline]
    pub(crate) fn at(&self, target: u32) -> &[f64; K] {
        &self.sums[self.places[target as usize] as usize]
    }

    /// The sum at a target, to be changed.
    pub(crate) fn at_mut(&mut self, target: u32) -> &mut [f64; K] {
        &mut self.sums[self.places[target as usize] as usize]
    }

    /// The sums in the order of their targets.
    pub(crate) fn in_order(&self) -> Vec<[f64; K]> {
        let mut all = zeroed_sums(self.places.len());
        for_chunks(&mut all, |first, chunk| {
            for (sum, &place) in chunk.iter_mut().zip(&self.places[first..]) {
                *sum = self.sums[place as usize];
            }
        });
        all
    }
}

impl<'a, const N: usize> Scatter<'a, N> {
    /// Finds the owners of targets `0..targets`.
    pub(crate) fn new(elements: &'a [[u32; N]], targets: usize) -> Self {
        let owners = owners(elements, targets);
        let count = |range: std::ops::Range<usize>| {
            let mut counts = [0; CHUNKS + 1];
            owners[range].iter().for_each(|owner| counts[*owner as usize] += 1);
            counts
        };
        // From counts in each range of targets to places: owner by owner, and with
        // one owner in the order of targets.
        let mut ranges: Vec<[u32; CHUNKS + 1]> = map_ranges(targets, count);
        let mut starts = [0; CHUNKS + 2];
        for owner in 0..=CHUNKS {
            let mut next = starts[owner];
            for range in &mut ranges {
                next += std::mem::replace(&mut range[owner], next);
            }
            starts[owner + 1] = next;
        }
        let mut places = zeroed(targets);
        for_chunks(&mut places, |first, chunk| {
            let mut next = ranges[first / chunk_len(targets)];
            for (place, owner) in chunk.iter_mut().zip(&owners[first..]) {
                *place = next[*owner as usize];
                next[*owner as usize] += 1;
            }
        });
        Self { elements, places, starts }
    }

    /// The sum at each target of what `contribution(element)` gives to it: `K`
    /// numbers for each of the element's targets.
    pub(crate) fn sum<const K: usize>(
        &self,
        contribution: impl Fn(usize) -> [[f64; K]; N] + Sync,
    ) -> Sums<'_, K> {
        let len = element_chunk_len(self.elements);
        let mut sums = zeroed_sums(self.places.len());
        let elements = self.elements.par_chunks(len).enumerate();
        let foreign: Vec<Foreign<K>> = elements
            .zip(self.owned(&mut sums))
            .map(|((chunk, elements), own)| {
                let mut foreign = std::array::from_fn(|_| Vec::new());
                for (k, targets) in elements.iter().enumerate() {
                    for (&target, value) in targets.iter().zip(contribution(chunk * len + k)) {
                        let place = self.places[target as usize];
                        // Places before the chunk's own wrap to large numbers.
                        match own.get_mut(place.wrapping_sub(self.starts[chunk]) as usize) {
                            Some(sum) => add(sum, &value),
                            None => foreign[self.owner(place)].push((place, value)),
                        }
                    }
                }
                foreign
            })
            .collect();
        self.owned(&mut sums).into_par_iter().enumerate().for_each(|(owner, own)| {
            for (place, value) in foreign.iter().flat_map(|lists| &lists[owner]) {
                add(&mut own[(place - self.starts[owner]) as usize], value);
            }
        });
        Sums { places: &self.places, sums }
    }

    /// The sums of each chunk's own targets.
    fn owned<'s, const K: usize>(&self, mut sums: &'s mut [[f64; K]]) -> Vec<&'s mut [[f64; K]]> {
        let mut owned = Vec::with_capacity(CHUNKS);
        for ends in self.starts.windows(2).take(CHUNKS) {
            let own;
            (own, sums) = sums.split_at_mut((ends[1] - ends[0]) as usize);
            owned.push(own);
        }
        owned
    }

    fn owner(&self, place: u32) -> usize {
        self.starts.partition_point(|start| *start <= place) - 1
    }
}

/// (place, value) for targets of other chunks, by their owners.
type Foreign<const K: usize> = [Vec<(u32, [f64; K])>; CHUNKS];

/// The first chunk that touches each target, or `CHUNKS`.
fn owners<const N: usize>(elements: &[[u32; N]], targets: usize) -> Vec<u8> {
    let owners: Vec<AtomicU8> = (0..targets).map(|_| AtomicU8::new(CHUNKS as u8)).collect();
    elements.par_chunks(element_chunk_len(elements)).enumerate().for_each(|(chunk, elements)| {
        for &target in elements.as_flattened() {
            let owner = &owners[target as usize];
            // Most targets were seen already: a plain load spares the costly
            // atomic minimum.
            if owner.load(Relaxed) > chunk as u8 {
                owner.fetch_min(chunk as u8, Relaxed);
            }
        }
    });
    owners.into_iter().map(AtomicU8::into_inner).collect()
}

fn zeroed_sums<const K: usize>(targets: usize) -> Vec<[f64; K]> {
    large_array::filled([0.0; K], targets)
}

#[inline]
fn add<const K: usize>(sum: &mut [f64; K], value: &[f64; K]) {
    (0..K).for_each(|k| sum[k] += value[k]);
}

fn element_chunk_len<T>(elements: &[T]) -> usize {
    elements.len().div_ceil(CHUNKS).max(256)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_one_element_after_another_for_any_number_of_threads() {
        // Few far-away targets, so that many chunks share them; the last have none.
        let (count, targets) = (40_000, 30_000);
        let target = |k: usize, i: usize| ((k / 2 + 7 * i * i * (k % 5)) % (targets - 9)) as u32;
        let elements: Vec<[u32; 3]> =
            (0..count).map(|k| std::array::from_fn(|i| target(k, i))).collect();
        let value = |k: usize| std::array::from_fn(|i| [(k % 17) as f64, (i + k % 3) as f64 - 1.0]);
        let mut slow = vec![[0.0; 2]; targets];
        for (k, targets) in elements.iter().enumerate() {
            for (target, value) in targets.iter().zip(value(k)) {
                add(&mut slow[*target as usize], &value);
            }
        }
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            // Small integers: every order of adding them gives the same.
            let scatter = pool.install(|| Scatter::new(&elements, targets));
            let sums = pool.install(|| scatter.sum(value));
            assert_eq!(sums.in_order(), slow);
            assert!((0..targets).all(|t| sums.at(t as u32) == &slow[t]));
            // Fractions: the same bits.
            let third = |k: usize| value(k).map(|v| v.map(|v| v / 3.0));
            let bits = pool.install(|| scatter.sum(third).in_order());
            assert_eq!(bits, Scatter::new(&elements, targets).sum(third).in_order());
        }
    }
}
