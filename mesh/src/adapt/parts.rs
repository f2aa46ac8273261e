//! The parts that simplices of one kind are split into, and whose they are.

use smallvec::SmallVec;

use octruss_base::large_array::zeroed;
use octruss_base::ragged;

/// The parts of one simplex of N vertices.
pub(super) type Parts<const N: usize> = SmallVec<[[u32; N]; 8]>;

/// How many parts each of so many simplices has.
pub(super) fn counts(simplices: usize, count: impl Fn(usize) -> usize + Sync) -> Vec<u8> {
    let mut counts = zeroed(simplices);
    octruss_base::chunks::for_chunks(&mut counts, |first, counts: &mut [u8]| {
        (first..).zip(counts).for_each(|(simplex, slot)| *slot = count(simplex) as u8);
    });
    counts
}

/// The parts of all simplices, one after another, and for each the simplex that it is
/// a part of.
///
/// # Panics
/// If a simplex has another number of parts than counted.
pub(super) fn all_parts<const N: usize>(
    counts: &[u8],
    parts: impl Fn(usize) -> Parts<N> + Sync,
) -> (Vec<[u32; N]>, Vec<u32>)
where
    [u32; N]: Default,
{
    let offsets = ragged::offsets(counts.len(), |simplex| usize::from(counts[simplex]));
    let total = offsets[counts.len()] as usize;
    let (mut all, mut parents) = (zeroed(total), zeroed(total));
    let arrays = (&mut all[..], &mut parents[..]);
    ragged::for_each(&offsets, arrays, |first, last, (all, parents)| {
        let mut at = 0;
        for simplex in first..last {
            let end = at + usize::from(counts[simplex]);
            all[at..end].copy_from_slice(&parts(simplex));
            parents[at..end].fill(simplex as u32);
            at = end;
        }
    });
    (all, parents)
}
