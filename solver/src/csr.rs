//! Compressed sparse rows with `u32` columns: the form all hot loops read.

use crate::error::Error;
use crate::real::Real;
use nalgebra_sparse::CsrMatrix;
use rayon::prelude::*;

/// A sparse matrix by rows, columns ascending in each row.
///
/// Twelve bytes an entry in double and eight in single precision, where the
/// public exchange form [`CsrMatrix`] takes sixteen.
#[derive(Debug, Clone, PartialEq)]
pub struct Csr<T> {
    columns: usize,
    /// Row i is entries `offsets[i]..offsets[i + 1]`.
    offsets: Vec<usize>,
    indices: Vec<u32>,
    values: Vec<T>,
}

impl<T: Copy> Csr<T> {
    /// A matrix with `columns` columns from its three arrays.
    ///
    /// # Errors
    /// [`Error::Malformed`] if offsets do not ascend from 0 to the number of
    /// entries, or a row's columns do not ascend strictly below `columns`.
    pub fn new(
        columns: usize,
        offsets: Vec<usize>,
        indices: Vec<u32>,
        values: Vec<T>,
    ) -> Result<Self, Error> {
        if values.len() != indices.len() {
            let what = "there must be one value for each column index";
            return Err(Error::Malformed { row: 0, what });
        }
        if let Some((row, what)) = first_fault(columns, &offsets, &indices) {
            return Err(Error::Malformed { row, what });
        }
        Ok(Self { columns, offsets, indices, values })
    }

    /// As [`Csr::new`] for arrays that are right by construction.
    pub(crate) fn trusted(
        columns: usize,
        offsets: Vec<usize>,
        indices: Vec<u32>,
        values: Vec<T>,
    ) -> Self {
        debug_assert_eq!(first_fault(columns, &offsets, &indices), None);
        debug_assert_eq!(values.len(), indices.len());
        Self { columns, offsets, indices, values }
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.offsets.len() - 1
    }

    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The number of stored entries.
    pub fn nonzeros(&self) -> usize {
        self.values.len()
    }

    /// The columns, ascending, and values of row `i`.
    #[inline]
    pub fn row(&self, i: usize) -> (&[u32], &[T]) {
        let entries = self.offsets[i]..self.offsets[i + 1];
        (&self.indices[entries.clone()], &self.values[entries])
    }

    /// Where each row begins in the arrays of entries, and their number at the end.
    pub fn offsets(&self) -> &[usize] {
        &self.offsets
    }

    /// The column of every entry, row by row.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// The value of every entry, row by row.
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// The entry at (`i`, `j`), or `None` where nothing is stored.
    pub fn get(&self, i: usize, j: usize) -> Option<T> {
        let (indices, values) = self.row(i);
        let at = indices.binary_search(&u32::try_from(j).ok()?).ok()?;
        Some(values[at])
    }

    /// The memory the three arrays take, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.offsets) + size_of_val(&*self.indices) + size_of_val(&*self.values)
    }
}

impl<T: Real> Csr<T> {
    /// The same matrix with every value rounded to `U`.
    pub fn cast<U: Real>(&self) -> Csr<U> {
        self.cast_scaled(1.0)
    }

    /// `scale` times the matrix, every value then rounded to `U`.
    pub(crate) fn cast_scaled<U: Real>(&self, scale: f64) -> Csr<U> {
        let round = |v: &T| U::from_f64(scale * v.to_f64());
        self.with_values(self.values.par_iter().map(round).collect())
    }

    /// The same pattern with other values.
    pub(crate) fn with_values<U: Real>(&self, values: Vec<U>) -> Csr<U> {
        assert_eq!(values.len(), self.indices.len());
        Csr {
            columns: self.columns,
            offsets: self.offsets.clone(),
            indices: self.indices.clone(),
            values,
        }
    }
}

/// The first row at fault in a pattern, and what must hold there.
fn first_fault(
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
            matrix.columns,
            matrix.offsets.clone(),
            matrix.indices.iter().map(|&j| j as usize).collect(),
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
        assert_eq!(ours.bytes(), 4 * 8 + 3 * 12);
    }
}
