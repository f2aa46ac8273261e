//! One row of a sparse result while it is summed up.

use crate::entry::Entry;

/// A dense row of which only the places touched since the last [`clear`] count.
///
/// [`clear`]: Accumulator::clear
pub(crate) struct Accumulator<E> {
    sums: Vec<E>,
    /// For each column the number of the last row that touched it. Zeroed memory
    /// costs nothing until it is used, so the first row is number 1.
    touched_by: Vec<u32>,
    row: u32,
    /// The columns touched, in the order of their first touch.
    pub(crate) touched: Vec<u32>,
}

impl<E: Entry> Accumulator<E> {
    pub(crate) fn new(columns: usize) -> Self {
        let (sums, touched_by) = (vec![E::default(); columns], vec![0; columns]);
        Self { sums, touched_by, row: 1, touched: Vec::new() }
    }

    /// Begins a new row.
    pub(crate) fn clear(&mut self) {
        self.row += 1;
        self.touched.clear();
    }

    /// The sum in a column, zero at the first touch.
    #[inline]
    pub(crate) fn at(&mut self, column: u32) -> &mut E {
        let j = column as usize;
        if self.touched_by[j] != self.row {
            self.touched_by[j] = self.row;
            self.sums[j] = E::default();
            self.touched.push(column);
        }
        &mut self.sums[j]
    }

    /// The sum in a column that was touched.
    #[inline]
    pub(crate) fn sum(&self, column: u32) -> E {
        self.sums[column as usize]
    }
}
