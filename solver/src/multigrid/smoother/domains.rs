//! Domains: the rows of a level in groups, so that most neighbours of a row are in its
//! own.
//!
//! Levels are numbered old vertices first, then the midpoints of edges: consecutive
//! rows are near each other, but the neighbours of a row come in several places. So a
//! domain is made of short runs of rows whose ancestors on coarse levels are near each
//! other.

use std::ops::Range;

/// Consecutive rows that stay together. Shorter runs make rounder domains and longer
/// lists; with 64 a fifth to a third more entries lie between domains.
const RUN: usize = 16;

/// More rows than a domain has: they are numbered by 16 bits.
pub(crate) const LIMIT: usize = 1 << 16;

/// The rows of a level cut into domains: by the level alone, never by the number of
/// threads.
#[derive(Debug, PartialEq)]
pub(crate) struct Domains {
    /// Where runs end, ascending, and their domains.
    runs: Vec<(usize, u32)>,
    /// The rows of each domain, ascending.
    ranges: Vec<Vec<Range<usize>>>,
}

impl Domains {
    /// Domains of a 32nd of the rows: more than most machines have threads. But at least
    /// 4 k rows, since smaller ones couple too much to each other, and at most 32 k, of
    /// which solution and residual stay in a core's cache.
    pub(crate) fn new(rows: usize, path: impl Fn(usize) -> Option<Vec<u32>>) -> Self {
        Self::of_size((rows / 32).clamp(4_096, LIMIT / 2), rows, path)
    }

    /// Domains of about `size` rows. Runs are sorted by `path`, the ancestors of a row
    /// from the coarsest to the finest; a run of rows without any goes with the one
    /// before it.
    pub(crate) fn of_size(
        size: usize,
        rows: usize,
        path: impl Fn(usize) -> Option<Vec<u32>>,
    ) -> Self {
        debug_assert!(size + RUN <= LIMIT);
        let mut last = Vec::new();
        let runs = (0..rows.div_ceil(RUN)).map(|run| {
            let mut members = run * RUN..rows.min((run + 1) * RUN);
            if let Some(found) = members.find_map(&path) {
                last = found;
            }
            (last.clone(), run)
        });
        let mut runs: Vec<(Vec<u32>, usize)> = runs.collect();
        runs.sort_unstable();
        let count = rows.div_ceil(size).max(1);
        let runs_of_each = runs.len().div_ceil(count).max(1);
        let mut domain_of = vec![0; runs.len()];
        for (place, (_, run)) in runs.iter().enumerate() {
            domain_of[*run] = place / runs_of_each;
        }
        Self::of_runs(rows, &domain_of)
    }

    /// From the domain of each run.
    fn of_runs(rows: usize, domain_of: &[usize]) -> Self {
        let count = domain_of.iter().max().map_or(1, |last| last + 1);
        let (mut runs, mut ranges) = (Vec::new(), vec![Vec::new(); count]);
        let mut first = 0;
        for same in domain_of.chunk_by(|a, b| a == b) {
            let end = rows.min(first + RUN * same.len());
            runs.push((end, same[0] as u32));
            ranges[same[0]].push(first..end);
            first = end;
        }
        Self { runs, ranges }
    }

    /// The rows of each domain, ascending.
    pub(crate) fn ranges(&self) -> &[Vec<Range<usize>>] {
        &self.ranges
    }

    /// A vector cut at the same places: for each domain its pieces, in order.
    pub(crate) fn pieces<'a, T>(&self, mut vector: &'a mut [T]) -> Vec<Vec<&'a mut [T]>> {
        let lengths = self.ranges.iter().map(Vec::len);
        let mut pieces: Vec<Vec<_>> = lengths.map(Vec::with_capacity).collect();
        let mut first = 0;
        for &(end, domain) in &self.runs {
            let piece;
            (piece, vector) = vector.split_at_mut(end - first);
            pieces[domain as usize].push(piece);
            first = end;
        }
        pieces
    }

    /// The memory of the lists, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        self.runs.len() * (size_of::<(usize, u32)>() + size_of::<Range<usize>>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_with_near_ancestors_share_a_domain() {
        // Six runs whose ancestors alternate between two; rows of the last two have none
        // and go with the run before. Three have the first, five the second.
        let path = |row: usize| (row < 6 * RUN).then(|| vec![(row / RUN % 2) as u32]);
        let domains = Domains::of_size(4 * RUN, 8 * RUN - 3, path);
        let expected = [[0..3 * RUN, 4 * RUN..5 * RUN], [3 * RUN..4 * RUN, 5 * RUN..8 * RUN - 3]];
        assert_eq!(domains.ranges(), expected);
    }

    #[test]
    fn pieces_are_the_rows_of_each_domain() {
        for rows in [0, 1, RUN, 1000] {
            let domains = Domains::of_size(100, rows, |row| Some(vec![(row * 7 % 11) as u32]));
            let mut vector: Vec<usize> = (0..rows).collect();
            for (pieces, ranges) in domains.pieces(&mut vector).iter().zip(domains.ranges()) {
                let pieces: Vec<usize> = pieces.iter().flat_map(|p| p.iter().copied()).collect();
                assert_eq!(pieces, ranges.iter().cloned().flatten().collect::<Vec<_>>());
                assert!(pieces.len() <= 100 + RUN);
            }
            let all: usize = domains.ranges().iter().flatten().map(ExactSizeIterator::len).sum();
            assert_eq!(all, rows);
        }
    }
}
