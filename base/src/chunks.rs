//! How long vectors are cut for parallel work: by length alone, never by the
//! number of threads, so that sums over chunks have the same bits everywhere.

use crate::workspaces::Workspaces;
use rayon::prelude::*;

/// Below this length a parallel loop costs more than it saves.
const SERIAL_BELOW: usize = 3_000;

/// The chunk length for `n` rows: about 64 chunks, each between 1 k and 16 k.
pub fn chunk_len(n: usize) -> usize {
    (n / 64).clamp(1_024, 16_384)
}

/// Runs `work(first, chunk)` over the chunks of `out`, where `first` is the
/// index of the chunk's first entry.
pub fn for_chunks<T: Send>(out: &mut [T], work: impl Fn(usize, &mut [T]) + Sync) {
    map_chunks(out, |first, chunk| work(first, chunk));
}

/// Runs `work` over the chunks of `out` and returns what it gave, in order.
pub fn map_chunks<T: Send, R: Send>(
    out: &mut [T],
    work: impl Fn(usize, &mut [T]) -> R + Sync,
) -> Vec<R> {
    let len = chunk_len(out.len());
    if out.len() < SERIAL_BELOW {
        out.chunks_mut(len).enumerate().map(|(c, chunk)| work(c * len, chunk)).collect()
    } else {
        out.par_chunks_mut(len).enumerate().map(|(c, chunk)| work(c * len, chunk)).collect()
    }
}

/// As [`map_chunks`] for two vectors of equal length, cut at the same places.
pub fn map_chunks2<T: Send, U: Send, R: Send>(
    a: &mut [T],
    b: &mut [U],
    work: impl Fn(usize, &mut [T], &mut [U]) -> R + Sync,
) -> Vec<R> {
    assert_eq!(a.len(), b.len());
    let len = chunk_len(a.len());
    if a.len() < SERIAL_BELOW {
        let pairs = a.chunks_mut(len).zip(b.chunks_mut(len)).enumerate();
        pairs.map(|(c, (a, b))| work(c * len, a, b)).collect()
    } else {
        let pairs = a.par_chunks_mut(len).zip(b.par_chunks_mut(len)).enumerate();
        pairs.map(|(c, (a, b))| work(c * len, a, b)).collect()
    }
}

/// Runs `work(range)` over the chunks of `0..n` and returns what it gave, in order.
pub fn map_ranges<R: Send>(n: usize, work: impl Fn(std::ops::Range<usize>) -> R + Sync) -> Vec<R> {
    let len = chunk_len(n);
    let range = |c: usize| c * len..((c + 1) * len).min(n);
    let count = n.div_ceil(len);
    if n < SERIAL_BELOW {
        (0..count).map(|c| work(range(c))).collect()
    } else {
        (0..count).into_par_iter().map(|c| work(range(c))).collect()
    }
}

/// As [`map_ranges`] where each of `0..n` is much work, with a workspace that
/// chunks done by the same thread share.
pub fn map_heavy_ranges<W: Send, R: Send>(
    n: usize,
    workspace: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, std::ops::Range<usize>) -> R + Sync,
) -> Vec<R> {
    let len = (n / 64).clamp(64, 4_096);
    let range = |c: usize| c * len..((c + 1) * len).min(n);
    let workspaces = Workspaces::default();
    let chunks = (0..n.div_ceil(len)).into_par_iter();
    chunks.map(|c| workspaces.lend(&workspace, |own| work(own, range(c)))).collect()
}
