//! Rows of a level that are aggregated together.

use std::ops::Range;

/// Consecutive rows in groups: one row for each vertex of the coarsest given level, below
/// it all rows that stand for one aggregate (two where it carries six rigid motions).
pub(crate) struct Nodes {
    /// Where the rows of each node begin, and at the end their number.
    offsets: Vec<u32>,
}

impl Nodes {
    /// A node for each row.
    pub(crate) fn single(rows: usize) -> Self {
        Self { offsets: (0..=rows as u32).collect() }
    }

    /// Nodes with so many rows each.
    pub(crate) fn of_sizes(sizes: impl Iterator<Item = usize>) -> Self {
        let mut end = 0;
        let ends = sizes.map(|size| {
            end += size as u32;
            end
        });
        Self { offsets: std::iter::once(0).chain(ends).collect() }
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The rows of all.
    pub(crate) fn row_count(&self) -> usize {
        self.offsets[self.count()] as usize
    }

    /// The rows of a node.
    pub(crate) fn rows(&self, node: usize) -> Range<usize> {
        self.offsets[node] as usize..self.offsets[node + 1] as usize
    }

    /// The node of each row.
    pub(crate) fn of_rows(&self) -> Vec<u32> {
        let rows = |node: usize| std::iter::repeat_n(node as u32, self.rows(node).len());
        (0..self.count()).flat_map(rows).collect()
    }
}
