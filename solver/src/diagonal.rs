//! The diagonal of a level's matrix and its inverse, by entries.

use crate::chunks::map_ranges;
use crate::csr::Csr;
use crate::entry::Entry;
use crate::error::Error;

/// The entries on the diagonal, numbers or blocks, all positive definite.
pub(crate) struct Diagonal<E> {
    pub(crate) entries: Vec<E>,
    pub(crate) inverses: Vec<E>,
}

impl<E: Entry<Real = f64>> Diagonal<E> {
    /// Of the matrix of a level, 0 the finest.
    ///
    /// # Errors
    /// [`Error::Diagonal`] at the first entry that is missing or not positive definite.
    pub(crate) fn new(matrix: &Csr<E>, level: usize) -> Result<Self, Error> {
        let entry = |row: usize| {
            let entry = matrix.get(row, row).unwrap_or_default();
            let inverse = entry.inverse().map_err(|value| Error::Diagonal { level, row, value })?;
            Ok((entry, inverse))
        };
        let chunks =
            map_ranges(matrix.rows(), |rows| rows.map(entry).collect::<Result<Vec<_>, _>>());
        let pairs = chunks.into_iter().collect::<Result<Vec<_>, _>>()?;
        let (entries, inverses) = pairs.into_iter().flatten().unzip();
        Ok(Self { entries, inverses })
    }
}
