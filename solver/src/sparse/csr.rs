//! Compressed sparse rows with `u32` columns: the form all hot loops read.

use crate::error::Error;
use crate::sparse::entry::Entry;
use crate::sparse::pattern::{Pattern, first_fault};
use nalgebra_sparse::CsrMatrix;
use octruss_base::chunks::for_chunks;
use octruss_base::large_array::zeroed;
use std::ops::Range;
use std::sync::Arc;

/// A sparse matrix by rows, columns ascending in each row; an entry is a number
/// or a 3 × 3 block (`[[f64; 3]; 3]`, row by row) in double or single precision.
///
/// Twelve bytes an entry in double and eight in single precision (blocks: 76 and
/// 40), where the public exchange form [`CsrMatrix`] takes sixteen. Matrices with
/// the same pattern, such as a matrix and its rounded copy, share it.
#[derive(Debug, Clone, PartialEq)]
pub struct Csr<E> {
    pattern: Arc<Pattern>,
    values: Vec<E>,
}

impl<E: Copy> Csr<E> {
    /// A matrix with `columns` columns from its three arrays: where each row
    /// begins, and at the end the number of entries; the column of each entry;
    /// its value.
    ///
    /// # Errors
    /// [`Error::Malformed`] if offsets do not ascend from 0 to the number of
    /// entries, or a row's columns do not ascend strictly below `columns`.
    pub fn new(
        columns: usize,
        offsets: Vec<usize>,
        indices: Vec<u32>,
        values: Vec<E>,
    ) -> Result<Self, Error> {
        if values.len() != indices.len() {
            let what = "there must be one value for each column index";
            return Err(Error::Malformed { row: 0, what });
        }
        if let Some((row, what)) = first_fault(columns, &offsets, &indices) {
            return Err(Error::Malformed { row, what });
        }
        Ok(Self { pattern: Arc::new(Pattern::new(columns, offsets, indices)), values })
    }

    /// As [`Csr::new`] for arrays that are right by construction.
    pub(crate) fn trusted(
        columns: usize,
        offsets: Vec<usize>,
        indices: Vec<u32>,
        values: Vec<E>,
    ) -> Self {
        debug_assert_eq!(first_fault(columns, &offsets, &indices), None);
        debug_assert_eq!(values.len(), indices.len());
        Self { pattern: Arc::new(Pattern::new(columns, offsets, indices)), values }
    }

    /// A matrix with a given pattern, which others may share.
    pub(crate) fn of(pattern: Arc<Pattern>, values: Vec<E>) -> Self {
        debug_assert_eq!(values.len(), pattern.indices.len());
        Self { pattern, values }
    }

    /// Where it has entries.
    pub(crate) fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.pattern.rows()
    }

    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.pattern.columns
    }

    /// The number of stored entries.
    pub fn nonzeros(&self) -> usize {
        self.values.len()
    }

    /// The columns, ascending, and values of row `i`.
    #[inline]
    pub fn row(&self, i: usize) -> (&[u32], &[E]) {
        let entries = self.pattern.row(i);
        (&self.pattern.indices[entries.clone()], &self.values[entries])
    }

    /// The columns and values of consecutive rows. Going through them is a quarter
    /// faster than asking for each: no offset is read twice or checked.
    #[inline]
    pub(crate) fn rows_in(&self, rows: Range<usize>) -> impl Iterator<Item = (&[u32], &[E])> {
        let start = self.pattern.offset(rows.start);
        let (mut indices, mut values) = (&self.pattern.indices[start..], &self.values[start..]);
        self.pattern.lengths(rows).map(move |length| {
            let (row_indices, row_values);
            (row_indices, indices) = indices.split_at(length);
            (row_values, values) = values.split_at(length);
            (row_indices, row_values)
        })
    }

    /// Where row `i` begins in the arrays of entries; for `i` = rows their number.
    #[inline]
    pub fn offset(&self, i: usize) -> usize {
        self.pattern.offset(i)
    }

    /// The column of every entry, row by row.
    pub fn indices(&self) -> &[u32] {
        &self.pattern.indices
    }

    /// The value of every entry, row by row.
    pub fn values(&self) -> &[E] {
        &self.values
    }

    /// The entry at (`i`, `j`), or `None` where nothing is stored.
    pub fn get(&self, i: usize, j: usize) -> Option<E> {
        let (indices, values) = self.row(i);
        let at = indices.binary_search(&u32::try_from(j).ok()?).ok()?;
        Some(values[at])
    }

    /// The memory the three arrays take, in bytes.
    pub fn bytes(&self) -> usize {
        self.pattern.bytes() + size_of_val(&*self.values)
    }

    /// The same pattern, shared, with other values.
    pub(crate) fn with_values<F>(&self, values: Vec<F>) -> Csr<F> {
        assert_eq!(values.len(), self.values.len());
        Csr { pattern: Arc::clone(&self.pattern), values }
    }
}

impl<E: Entry> Csr<E> {
    /// The same matrix with every value rounded to `F`.
    pub fn cast<F: Entry>(&self) -> Csr<F> {
        self.cast_scaled(1.0)
    }

    /// A + s I with a number s for each row; rows that store no diagonal entry are left as
    /// they are. The pattern is shared.
    ///
    /// ```
    /// let a = octruss_solver::Csr::new(2, vec![0, 2, 3], vec![0, 1, 1], vec![1.0, 2.0, 4.0])?;
    /// assert_eq!(a.plus_diagonal(&[0.5, 0.25]).values(), [1.5, 2.0, 4.25]);
    /// # Ok::<(), octruss_solver::Error>(())
    /// ```
    ///
    /// # Panics
    /// Unless there is one number for each row.
    pub fn plus_diagonal(&self, numbers: &[E::Real]) -> Self {
        assert_eq!(numbers.len(), self.rows());
        let mut values = self.values.clone();
        for (row, &number) in numbers.iter().enumerate() {
            if let Ok(place) = self.row(row).0.binary_search(&(row as u32)) {
                let diagonal = &mut values[self.offset(row) + place];
                *diagonal = diagonal.add_scaled(number, E::identity());
            }
        }
        self.with_values(values)
    }

    /// `scale` times the matrix, every value then rounded to `F`.
    pub(crate) fn cast_scaled<F: Entry>(&self, scale: f64) -> Csr<F> {
        self.with_values(cast_all(&self.values, scale))
    }
}

/// `scale` times all values, then rounded to `F`.
pub(crate) fn cast_all<E: Entry, F: Entry>(values: &[E], scale: f64) -> Vec<F> {
    let mut all: Vec<F> = zeroed(values.len());
    for_chunks(&mut all, |first, chunk| {
        for (rounded, value) in chunk.iter_mut().zip(&values[first..]) {
            *rounded = value.cast_scaled(scale);
        }
    });
    all
}

impl TryFrom<&CsrMatrix<f64>> for Csr<f64> {
    type Error = Error;

    /// # Errors
    /// [`Error::Malformed`] if there are more columns than `u32` can number.
    fn try_from(matrix: &CsrMatrix<f64>) -> Result<Self, Error> {
        let too_wide = Error::Malformed { row: 0, what: "there must be at most 2^32 columns" };
        u32::try_from(matrix.ncols()).map_err(|_| too_wide)?;
        Self::new(
            matrix.ncols(),
            matrix.row_offsets().to_vec(),
            matrix.col_indices().iter().map(|&j| j as u32).collect(),
            matrix.values().to_vec(),
        )
    }
}

impl From<&Csr<f64>> for CsrMatrix<f64> {
    fn from(matrix: &Csr<f64>) -> Self {
        CsrMatrix::try_from_csr_data(
            matrix.rows(),
            matrix.columns(),
            (0..=matrix.rows()).map(|i| matrix.offset(i)).collect(),
            matrix.indices().iter().map(|&j| j as usize).collect(),
            matrix.values.clone(),
        )
        .expect("both types ask for ascending columns within bounds")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn malformed_arrays_are_refused() {
        let refused = |offsets: &[usize], indices: &[u32]| {
            Csr::new(2, offsets.to_vec(), indices.to_vec(), vec![1.0; indices.len()]).is_err()
        };
        assert!(refused(&[], &[]), "no offsets");
        assert!(refused(&[0, 1], &[0, 1]), "last offset");
        assert!(refused(&[0, 3, 2], &[0, 1]), "offset past the end");
        assert!(refused(&[0, 2], &[1, 0]), "descending columns");
        assert!(refused(&[0, 2], &[1, 1]), "a column twice");
        assert!(refused(&[0, 1], &[2]), "column out of range");
        assert!(!refused(&[0, 2, 2], &[0, 1]), "an empty row is fine");
    }

    #[test]
    fn both_forms_convert_into_each_other() {
        let ours = Csr::new(3, vec![0, 2, 2, 3], vec![0, 2, 1], vec![1.0, -2.0, 0.5]).unwrap();
        let public = CsrMatrix::from(&ours);
        assert_eq!(public.get_entry(0, 2).unwrap().into_value(), -2.0);
        assert_eq!(Csr::try_from(&public).unwrap(), ours);
        assert_eq!((ours.get(2, 1), ours.get(1, 1)), (Some(0.5), None));
        assert_eq!(ours.bytes(), 4 * 4 + 3 * 12);
    }
}
