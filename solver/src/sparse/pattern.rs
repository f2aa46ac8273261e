//! Where a sparse matrix has entries; shared by matrices that differ in values.

use octruss_base::chunks::for_chunks;
use octruss_base::large_array::zeroed;
use std::ops::Range;
use std::slice::Windows;

/// The places of entries by rows, columns ascending in each row.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Pattern {
    pub(crate) columns: usize,
    /// Row i is entries `offsets[i]..offsets[i + 1]`.
    offsets: Offsets,
    pub(crate) indices: Vec<u32>,
}

/// Four bytes an offset wherever that suffices.
#[derive(Debug, Clone, PartialEq)]
enum Offsets {
    Narrow(Vec<u32>),
    Wide(Vec<usize>),
}

impl Pattern {
    pub(crate) fn new(columns: usize, offsets: Vec<usize>, indices: Vec<u32>) -> Self {
        let offsets = if u32::try_from(indices.len()).is_ok() {
            let mut narrow = zeroed(offsets.len());
            for_chunks(&mut narrow, |first, chunk| {
                let given = chunk.iter_mut().zip(&offsets[first..]);
                given.for_each(|(narrow, &at)| *narrow = at as u32);
            });
            Offsets::Narrow(narrow)
        } else {
            Offsets::Wide(offsets)
        };
        Self { columns, offsets, indices }
    }

    pub(crate) fn rows(&self) -> usize {
        match &self.offsets {
            Offsets::Narrow(offsets) => offsets.len() - 1,
            Offsets::Wide(offsets) => offsets.len() - 1,
        }
    }

    /// Where row `i` begins; for i = rows the number of entries.
    #[inline]
    pub(crate) fn offset(&self, i: usize) -> usize {
        match &self.offsets {
            Offsets::Narrow(offsets) => offsets[i] as usize,
            Offsets::Wide(offsets) => offsets[i],
        }
    }

    /// The entries of row `i`.
    #[inline]
    pub(crate) fn row(&self, i: usize) -> Range<usize> {
        match &self.offsets {
            Offsets::Narrow(offsets) => offsets[i] as usize..offsets[i + 1] as usize,
            Offsets::Wide(offsets) => offsets[i]..offsets[i + 1],
        }
    }

    /// The columns of row `i` from its diagonal on.
    pub(crate) fn upper_row(&self, i: usize) -> &[u32] {
        let columns = &self.indices[self.row(i)];
        &columns[columns.partition_point(|&j| (j as usize) < i)..]
    }

    /// The numbers of entries of the rows given, in order.
    #[inline]
    pub(crate) fn lengths(&self, rows: Range<usize>) -> Lengths<'_> {
        match &self.offsets {
            Offsets::Narrow(offsets) => Lengths::Narrow(offsets[rows.start..=rows.end].windows(2)),
            Offsets::Wide(offsets) => Lengths::Wide(offsets[rows.start..=rows.end].windows(2)),
        }
    }

    pub(crate) fn bytes(&self) -> usize {
        let offsets = match &self.offsets {
            Offsets::Narrow(offsets) => size_of_val(&**offsets),
            Offsets::Wide(offsets) => size_of_val(&**offsets),
        };
        offsets + size_of_val(&*self.indices)
    }
}

/// Numbers of entries of consecutive rows.
pub(crate) enum Lengths<'a> {
    Narrow(Windows<'a, u32>),
    Wide(Windows<'a, usize>),
}

impl Iterator for Lengths<'_> {
    type Item = usize;

    #[inline]
    fn next(&mut self) -> Option<usize> {
        match self {
            Self::Narrow(ends) => ends.next().map(|ends| (ends[1] - ends[0]) as usize),
            Self::Wide(ends) => ends.next().map(|ends| ends[1] - ends[0]),
        }
    }
}

/// The first row at fault in a pattern, and what must hold there.
pub(crate) fn first_fault(
    columns: usize,
    offsets: &[usize],
    indices: &[u32],
) -> Option<(usize, &'static str)> {
    if offsets.first() != Some(&0) || offsets.last() != Some(&indices.len()) {
        return Some((0, "row offsets must run from 0 to the number of entries"));
    }
    offsets.windows(2).enumerate().find_map(|(row, ends)| {
        let Some(row_indices) = indices.get(ends[0]..ends[1]) else {
            return Some((row, "row offsets must ascend"));
        };
        let ascending = row_indices.windows(2).all(|pair| pair[0] < pair[1]);
        let within = row_indices.last().is_none_or(|&j| (j as usize) < columns);
        (!ascending || !within)
            .then_some((row, "columns must ascend and be less than their number"))
    })
}
