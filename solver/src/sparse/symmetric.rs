//! A symmetric matrix from its upper triangle.

use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::pattern::Pattern;
use crate::sparse::rows::{for_rows, offsets};
use octruss_base::groups::Groups;
use octruss_base::large_array::zeroed;
use std::sync::Arc;

/// Consecutive rows of an upper triangle, each with ascending columns from the
/// diagonal on.
pub(crate) struct UpperRows<E> {
    lengths: Vec<u32>,
    indices: Vec<u32>,
    values: Vec<E>,
}

impl<E> Default for UpperRows<E> {
    fn default() -> Self {
        Self { lengths: Vec::new(), indices: Vec::new(), values: Vec::new() }
    }
}

impl<E> UpperRows<E> {
    /// Appends a row.
    #[inline]
    pub(crate) fn push(&mut self, entries: impl Iterator<Item = (u32, E)>) {
        let before = self.indices.len();
        for (column, value) in entries {
            self.indices.push(column);
            self.values.push(value);
        }
        self.lengths.push((self.indices.len() - before) as u32);
    }

    fn rows(&self) -> impl Iterator<Item = (&[u32], &[E])> {
        let mut start = 0;
        self.lengths.iter().map(move |&length| {
            let entries = start..start + length as usize;
            start = entries.end;
            (&self.indices[entries.clone()], &self.values[entries])
        })
    }
}

/// The n × n matrix with these upper rows in order, its pattern given if it is
/// known. Entries below the diagonal are the transposes of those above; diagonal
/// blocks are replaced by their symmetric parts.
pub(crate) fn from_upper<E: Entry<Real = f64>>(
    n: usize,
    chunks: &[UpperRows<E>],
    known: Option<&Arc<Pattern>>,
) -> Csr<E> {
    let upper: Vec<(&[u32], &[E])> = chunks.iter().flat_map(UpperRows::rows).collect();
    debug_assert_eq!(upper.len(), n);
    let pattern = known.cloned().unwrap_or_else(|| {
        let columns: Vec<&[u32]> = upper.iter().map(|(columns, _)| *columns).collect();
        Arc::new(mirrored(&columns))
    });
    let mut values: Vec<E> = zeroed(pattern.indices.len());
    for_rows(
        n,
        |row| pattern.offset(row),
        &mut values[..],
        |i, values: &mut [E]| {
            let columns = &pattern.indices[pattern.row(i)];
            let (low_values, high_values) = values.split_at_mut(columns.len() - upper[i].0.len());
            high_values.copy_from_slice(upper[i].1);
            if upper[i].0.first() == Some(&(i as u32)) {
                let block = high_values[0];
                high_values[0] = block.transposed().add_scaled(1.0, block).scaled(0.5);
            }
            for (value, &j) in low_values.iter_mut().zip(columns) {
                let (columns, values) = upper[j as usize];
                let at = columns.partition_point(|&k| (k as usize) < i);
                *value = values[at].transposed();
            }
        },
    );
    Csr::of(pattern, values)
}

/// The symmetric pattern with these columns, in each row from the diagonal on.
fn mirrored(upper: &[&[u32]]) -> Pattern {
    let n = upper.len();
    let strictly = |i: usize| upper[i].iter().filter(move |&&j| j as usize > i);
    let lower = Groups::new(n, n, |i| strictly(i).map(move |&j| (j, i as u32)));
    let offsets = offsets(n, |i| lower.of(i).len() + upper[i].len());
    let mut indices: Vec<u32> = zeroed(offsets[n]);
    for_rows(
        n,
        |row| offsets[row],
        &mut indices[..],
        |i, indices: &mut [u32]| {
            let (low, high) = indices.split_at_mut(lower.of(i).len());
            low.copy_from_slice(lower.of(i));
            high.copy_from_slice(upper[i]);
        },
    );
    Pattern::new(n, offsets, indices)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_several_chunks_are_mirrored() {
        let [mut first, mut second] = [UpperRows::default(), UpperRows::default()];
        first.push([(0, 1.0), (2, 5.0)].into_iter());
        first.push([(2, 7.0)].into_iter());
        second.push([(2, 3.0)].into_iter());
        let expected = Csr::new(
            3,
            vec![0, 2, 3, 6],
            vec![0, 2, 2, 0, 1, 2],
            vec![1.0, 5.0, 7.0, 5.0, 7.0, 3.0],
        );
        assert_eq!(from_upper(3, &[first, second], None), expected.unwrap());
    }
}
