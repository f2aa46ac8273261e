//! One row of a sparse result while it is summed up.

use crate::sparse::entry::Entry;
use octruss_base::large_array::zeroed;
use std::mem::take;

/// A dense row of which only the places touched since the last [`clear`] count.
///
/// Adding takes no branch: half of them could not be foreseen.
///
/// [`clear`]: Accumulator::clear
pub(crate) struct Accumulator<E> {
    slots: Vec<Slot<E>>,
    row: u32,
    /// The columns touched, in the order of their first touch; then room for more.
    touched: Vec<u32>,
    count: usize,
}

#[derive(Clone, Copy, Default)]
struct Slot<E> {
    /// Zero unless touched.
    sum: E,
    /// The number of the last row that touched it. Zeroed memory costs nothing
    /// until it is used, so the first row is number 1.
    touched_by: u32,
}

impl<E: Entry> Accumulator<E> {
    pub(crate) fn new(columns: usize) -> Self {
        Self { slots: zeroed(columns), row: 1, touched: zeroed(columns + 1), count: 0 }
    }

    /// Begins a new row. The sums of the last one must have been taken.
    pub(crate) fn clear(&mut self) {
        self.row += 1;
        self.count = 0;
    }

    /// Adds factor · value in each (column, factor, value).
    ///
    /// Never inlined: among the variables of a caller the pointers of this loop would
    /// be fetched from the stack in every step.
    #[inline(never)]
    pub(crate) fn add(&mut self, terms: impl Iterator<Item = (u32, E::Real, E)>) {
        let (slots, touched) = (&mut self.slots[..], &mut self.touched[..]);
        let (row, mut count) = (self.row, self.count);
        for (column, factor, value) in terms {
            let slot = &mut slots[column as usize];
            touched[count] = column;
            count += usize::from(slot.touched_by != row);
            slot.touched_by = row;
            slot.sum = slot.sum.add_scaled(factor, value);
        }
        self.count = count;
    }

    /// Puts the columns touched in ascending order.
    pub(crate) fn sort(&mut self) {
        self.touched[..self.count].sort_unstable();
    }

    /// How many columns are touched.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// The columns touched and their sums, which are zero from now on.
    #[inline]
    pub(crate) fn drain(&mut self) -> impl ExactSizeIterator<Item = (u32, E)> {
        let slots = &mut self.slots;
        let touched = self.touched[..self.count].iter();
        touched.map(|&column| (column, take(&mut slots[column as usize].sum)))
    }

    /// The sum in a column, which is zero from now on.
    #[inline]
    pub(crate) fn take(&mut self, column: u32) -> E {
        take(&mut self.slots[column as usize].sum)
    }
}
