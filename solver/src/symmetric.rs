//! A symmetric matrix from its upper triangle.

use crate::csr::Csr;
use crate::entry::Entry;
use crate::rows::build_rows;

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
    pub(crate) fn push(&mut self, columns: &[u32], values: impl Iterator<Item = E>) {
        self.lengths.push(columns.len() as u32);
        self.indices.extend_from_slice(columns);
        self.values.extend(values);
    }
}

/// The n × n matrix with these upper rows in order. Entries below the diagonal are
/// the transposes of those above; diagonal blocks are replaced by their symmetric
/// parts.
pub(crate) fn from_upper<E: Entry<Real = f64>>(n: usize, chunks: &[UpperRows<E>]) -> Csr<E> {
    let upper: Vec<(&[u32], &[E])> = chunks.iter().flat_map(rows_of).collect();
    debug_assert_eq!(upper.len(), n);
    let lower = Lower::new(&upper);
    build_rows(
        (n, n),
        |i| lower.row(i).len() + upper[i].0.len(),
        |i, indices, values| {
            let below = lower.row(i);
            let (low_indices, high_indices) = indices.split_at_mut(below.len());
            let (low_values, high_values) = values.split_at_mut(below.len());
            high_indices.copy_from_slice(upper[i].0);
            high_values.copy_from_slice(upper[i].1);
            if high_indices.first() == Some(&(i as u32)) {
                let block = high_values[0];
                high_values[0] = block.transposed().add_scaled(1.0, block).scaled(0.5);
            }
            let places = low_indices.iter_mut().zip(low_values);
            for (&(row, at), (index, value)) in below.iter().zip(places) {
                *index = row;
                *value = upper[row as usize].1[at as usize].transposed();
            }
        },
    )
}

fn rows_of<E>(chunk: &UpperRows<E>) -> impl Iterator<Item = (&[u32], &[E])> {
    let mut start = 0;
    chunk.lengths.iter().map(move |&length| {
        let entries = start..start + length as usize;
        start = entries.end;
        (&chunk.indices[entries.clone()], &chunk.values[entries])
    })
}

/// For each row the entries above the diagonal of its column, as (row, place in
/// that row).
struct Lower {
    offsets: Vec<usize>,
    entries: Vec<(u32, u32)>,
}

impl Lower {
    fn new<E>(upper: &[(&[u32], &[E])]) -> Self {
        let strictly = |i: usize| upper[i].0.iter().filter(move |&&j| j as usize > i);
        let mut offsets = vec![0; upper.len() + 1];
        for i in 0..upper.len() {
            strictly(i).for_each(|&j| offsets[j as usize + 1] += 1);
        }
        for i in 0..upper.len() {
            offsets[i + 1] += offsets[i];
        }
        let mut next = offsets.clone();
        let mut entries = vec![(0, 0); offsets[upper.len()]];
        for (i, (columns, _)) in upper.iter().enumerate() {
            for (at, &j) in columns.iter().enumerate().filter(|(_, j)| **j as usize > i) {
                entries[next[j as usize]] = (i as u32, at as u32);
                next[j as usize] += 1;
            }
        }
        Self { offsets, entries }
    }

    fn row(&self, i: usize) -> &[(u32, u32)] {
        &self.entries[self.offsets[i]..self.offsets[i + 1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_several_chunks_are_mirrored() {
        let [mut first, mut second] = [UpperRows::default(), UpperRows::default()];
        first.push(&[0, 2], [1.0, 5.0].into_iter());
        first.push(&[2], [7.0].into_iter());
        second.push(&[2], [3.0].into_iter());
        let expected = Csr::new(
            3,
            vec![0, 2, 3, 6],
            vec![0, 2, 2, 0, 1, 2],
            vec![1.0, 5.0, 7.0, 5.0, 7.0, 3.0],
        );
        assert_eq!(from_upper(3, &[first, second]), expected.unwrap());
    }
}
