//! Adding element contributions to shared targets, in parallel and with the
//! same bits for any number of threads.
//!
//! The elements are cut into fixed chunks. A target belongs to the first chunk
//! that touches it; that chunk alone adds to it directly, in element order.
//! What other chunks contribute goes to lists, which the owner adds afterwards in
//! chunk order. Neighbouring elements share most targets, so the lists are short.

use octruss_base::chunks::for_chunks;
use octruss_base::large_array::{filled, zeros};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicU8, AtomicU64, Ordering::Relaxed};

/// Enough to balance the load, few enough for their numbers to fit a byte.
const CHUNKS: usize = 64;

/// Which chunk of elements owns each target, for elements with `N` targets.
pub(crate) struct Scatter<'a, const N: usize> {
    elements: &'a [[u32; N]],
    /// The first chunk that touches each target, or `CHUNKS`.
    owners: Vec<u8>,
}

/// A sum of `K` numbers for each target.
pub(crate) struct Sums<const K: usize> {
    /// Bits of doubles. Only the owner of a target touches its sum, with plain loads and
    /// stores; atomics tell the compiler that others may touch what lies beside it.
    bits: Vec<AtomicU64>,
}

impl<const K: usize> Sums<K> {
    fn zero(targets: usize) -> Self {
        Self { bits: zeros(K * targets) }
    }

    /// The sum at a target.
    #[inline]
    pub(crate) fn at(&self, target: u32) -> [f64; K] {
        let first = K * target as usize;
        let bits = &self.bits[first..first + K];
        std::array::from_fn(|k| f64::from_bits(bits[k].load(Relaxed)))
    }

    /// Adds to the sum at a target. Of two additions to one target at once, one may be lost.
    #[inline]
    fn add(&self, target: u32, value: &[f64; K]) {
        let first = K * target as usize;
        for (bits, value) in self.bits[first..first + K].iter().zip(value) {
            let sum = f64::from_bits(bits.load(Relaxed)) + value;
            bits.store(sum.to_bits(), Relaxed);
        }
    }

    /// Adds to the sum at a target; nobody else can meanwhile.
    pub(crate) fn add_to(&mut self, target: u32, value: [f64; K]) {
        self.add(target, &value);
    }

    /// Adds what chunks found for targets of others, owner by owner.
    fn plus(self, foreign: Vec<Foreign<K>>) -> Self {
        (0..CHUNKS).into_par_iter().for_each(|owner| {
            for (target, value) in foreign.iter().flat_map(|lists| &lists[owner]) {
                self.add(*target, value);
            }
        });
        self
    }

    /// The sums in the order of their targets.
    pub(crate) fn in_order(&self) -> Vec<[f64; K]> {
        let mut all = filled([0.0; K], self.bits.len() / K);
        for_chunks(&mut all, |first, chunk| {
            chunk.iter_mut().enumerate().for_each(|(k, sum)| *sum = self.at((first + k) as u32));
        });
        all
    }
}

impl<'a, const N: usize> Scatter<'a, N> {
    /// Finds the owners of targets `0..targets`.
    pub(crate) fn new(elements: &'a [[u32; N]], targets: usize) -> Self {
        let owners: Vec<AtomicU8> = (0..targets).map(|_| AtomicU8::new(CHUNKS as u8)).collect();
        elements.par_chunks(element_chunk_len(elements)).enumerate().for_each(
            |(chunk, elements)| {
                for &target in elements.as_flattened() {
                    let owner = &owners[target as usize];
                    // Most targets were seen already: a plain load spares the costly
                    // atomic minimum.
                    if owner.load(Relaxed) > chunk as u8 {
                        owner.fetch_min(chunk as u8, Relaxed);
                    }
                }
            },
        );
        Self { elements, owners: owners.into_iter().map(AtomicU8::into_inner).collect() }
    }

    /// The sum at each target of what `contribution(element)` gives to it: `K`
    /// numbers for each of the element's targets.
    pub(crate) fn sum<const K: usize>(
        &self,
        contribution: impl Fn(usize) -> [[f64; K]; N] + Sync,
    ) -> Sums<K> {
        self.sum_over(|_| true, contribution)
    }

    /// The same of those elements alone that take part.
    pub(crate) fn sum_over<const K: usize>(
        &self,
        takes_part: impl Fn(usize) -> bool + Sync,
        contribution: impl Fn(usize) -> [[f64; K]; N] + Sync,
    ) -> Sums<K> {
        let sums = Sums::zero(self.owners.len());
        let chunks = self.chunks().map(|(chunk, elements)| {
            let mut adding = Adding::new(chunk, &self.owners, &sums);
            let those = elements.filter(|&k| takes_part(k));
            those.for_each(|k| adding.add(&self.elements[k], &contribution(k)));
            adding.foreign
        });
        let foreign = chunks.collect();
        sums.plus(foreign)
    }

    /// The sums at the targets of the same elements here and in `other`, in one pass.
    pub(crate) fn sum_beside<const M: usize, const K: usize, const L: usize>(
        &self,
        other: &Scatter<M>,
        contribution: impl Fn(usize) -> ([[f64; K]; N], [[f64; L]; M]) + Sync,
    ) -> (Sums<K>, Sums<L>) {
        assert_eq!(self.elements.len(), other.elements.len());
        let (sums, others) = (Sums::zero(self.owners.len()), Sums::zero(other.owners.len()));
        let chunks = self.chunks().map(|(chunk, elements)| {
            let mut adding = Adding::new(chunk, &self.owners, &sums);
            let mut beside = Adding::new(chunk, &other.owners, &others);
            elements.for_each(|k| {
                let (values, other_values) = contribution(k);
                adding.add(&self.elements[k], &values);
                beside.add(&other.elements[k], &other_values);
            });
            (adding.foreign, beside.foreign)
        });
        let (foreign, other_foreign) = chunks.unzip();
        (sums.plus(foreign), others.plus(other_foreign))
    }

    /// The chunks with their elements.
    fn chunks(&self) -> impl IndexedParallelIterator<Item = (usize, Range<usize>)> {
        let (count, len) = (self.elements.len(), element_chunk_len(self.elements));
        let elements = move |chunk: usize| chunk * len..(chunk * len + len).min(count);
        (0..count.div_ceil(len)).into_par_iter().map(move |chunk| (chunk, elements(chunk)))
    }
}

/// A chunk on its way through its elements.
struct Adding<'a, const K: usize> {
    chunk: usize,
    owners: &'a [u8],
    sums: &'a Sums<K>,
    foreign: Foreign<K>,
}

impl<'a, const K: usize> Adding<'a, K> {
    fn new(chunk: usize, owners: &'a [u8], sums: &'a Sums<K>) -> Self {
        Self { chunk, owners, sums, foreign: std::array::from_fn(|_| Vec::new()) }
    }

    /// Adds what an element gives to its targets.
    #[inline]
    fn add<const N: usize>(&mut self, targets: &[u32; N], values: &[[f64; K]; N]) {
        for (&target, value) in targets.iter().zip(values) {
            let owner = usize::from(self.owners[target as usize]);
            if owner == self.chunk {
                self.sums.add(target, value);
            } else {
                self.foreign[owner].push((target, *value));
            }
        }
    }
}

/// (target, value) for targets of other chunks, by their owners.
type Foreign<const K: usize> = [Vec<(u32, [f64; K])>; CHUNKS];

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
                let sums = slow[*target as usize].iter_mut();
                sums.zip(value).for_each(|(sum, value): (&mut f64, f64)| *sum += value);
            }
        }
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            // Small integers: every order of adding them gives the same.
            let scatter = pool.install(|| Scatter::new(&elements, targets));
            let sums = pool.install(|| scatter.sum(value));
            assert_eq!(sums.in_order(), slow);
            assert!((0..targets).all(|t| sums.at(t as u32) == slow[t]));
            // Fractions: the same bits.
            let third = |k: usize| value(k).map(|v| v.map(|v| v / 3.0));
            let bits = pool.install(|| scatter.sum(third).in_order());
            assert_eq!(bits, Scatter::new(&elements, targets).sum(third).in_order());
            // Elements that take no part are as if they gave nothing.
            let some = |k: usize| k % 3 != 1;
            let nothing_else = |k: usize| if some(k) { third(k) } else { [[0.0; 2]; 3] };
            let of_some = pool.install(|| scatter.sum_over(some, third).in_order());
            assert_eq!(of_some, scatter.sum(nothing_else).in_order());
            assert_ne!(of_some, bits);
            // Beside other targets nothing changes.
            let firsts: Vec<[u32; 1]> = elements.iter().map(|[first, ..]| [*first]).collect();
            let at_firsts = Scatter::new(&firsts, targets);
            let both = |k: usize| (third(k), [third(k)[0]]);
            let (sums, at_firsts_too) = pool.install(|| scatter.sum_beside(&at_firsts, both));
            assert_eq!(sums.in_order(), scatter.sum(third).in_order());
            let alone = at_firsts.sum(|k| [third(k)[0]]);
            assert_eq!(at_firsts_too.in_order(), alone.in_order());
        }
        let nothing = Scatter::<3>::new(&[], 2).sum(|_| [[1.0]; 3]);
        assert_eq!(nothing.in_order(), [[0.0]; 2]);
    }
}
