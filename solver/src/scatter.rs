//! Adding element contributions to shared targets, in parallel and with the
//! same bits for any number of threads.
//!
//! The elements are cut into fixed chunks. A target belongs to the first chunk
//! that touches it; that chunk alone adds to it directly, in element order.
//! What other chunks contribute goes to lists, added afterwards in chunk order.
//! Neighbouring elements share most targets, so the lists are short.

use rayon::prelude::*;
use std::sync::atomic::{AtomicU8, AtomicU64, Ordering::Relaxed};

/// Enough to balance the load, few enough for their numbers to fit a byte.
const CHUNKS: usize = 64;
const UNTOUCHED: u8 = u8::MAX;

/// Which chunk of elements owns each target, for elements with `N` targets.
pub(crate) struct Scatter<'a, const N: usize> {
    elements: &'a [[u32; N]],
    owners: Vec<u8>,
}

impl<'a, const N: usize> Scatter<'a, N> {
    /// Finds the owners of targets `0..targets`.
    pub(crate) fn new(elements: &'a [[u32; N]], targets: usize) -> Self {
        let owners: Vec<AtomicU8> = (0..targets).map(|_| AtomicU8::new(UNTOUCHED)).collect();
        elements.par_chunks(chunk_len(elements)).enumerate().for_each(|(chunk, elements)| {
            for &target in elements.as_flattened() {
                let owner = &owners[target as usize];
                // Most targets were seen already: a plain load spares the
                // costly atomic minimum.
                if owner.load(Relaxed) > chunk as u8 {
                    owner.fetch_min(chunk as u8, Relaxed);
                }
            }
        });
        Self { elements, owners: owners.into_iter().map(AtomicU8::into_inner).collect() }
    }

    /// The sum at each target of what `contribution(element)` gives to it: `K`
    /// numbers for each of the element's targets.
    pub(crate) fn sum<const K: usize>(
        &self,
        contribution: impl Fn(usize) -> [[f64; K]; N] + Sync,
    ) -> Vec<[f64; K]> {
        let len = chunk_len(self.elements);
        // Only its owner writes a target, so relaxed loads and stores, which
        // cost no more than plain ones, suffice. The bits of 0.0 are 0.
        let zero = || [const { AtomicU64::new(0) }; K];
        let sums: Vec<[AtomicU64; K]> = self.owners.iter().map(|_| zero()).collect();
        let add = |target: u32, values: [f64; K]| {
            for (sum, value) in sums[target as usize].iter().zip(values) {
                sum.store((f64::from_bits(sum.load(Relaxed)) + value).to_bits(), Relaxed);
            }
        };
        let chunks = self.elements.par_chunks(len).enumerate();
        let foreign: Vec<Vec<(u32, [f64; K])>> = chunks
            .map(|(chunk, elements)| {
                let mut foreign = Vec::new();
                for (k, targets) in elements.iter().enumerate() {
                    for (&target, value) in targets.iter().zip(contribution(chunk * len + k)) {
                        if self.owners[target as usize] == chunk as u8 {
                            add(target, value);
                        } else {
                            foreign.push((target, value));
                        }
                    }
                }
                foreign
            })
            .collect();
        for &(target, value) in foreign.iter().flatten() {
            add(target, value);
        }
        let number = |sum: AtomicU64| f64::from_bits(sum.into_inner());
        sums.into_iter().map(|target| target.map(number)).collect()
    }
}

fn chunk_len<T>(elements: &[T]) -> usize {
    elements.len().div_ceil(CHUNKS).max(256)
}
