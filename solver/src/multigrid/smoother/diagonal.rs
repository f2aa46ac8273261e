//! The diagonal that a smoother inverts, by entries.

use crate::error::Error;
use crate::krylov::lanczos::{UpperEnd, largest_eigenvalue};
use crate::krylov::operator::Operator;
use crate::multigrid::options::DiagonalKind;
use crate::multigrid::projectors::Projectors;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use octruss_base::chunks::map_chunks;
use octruss_base::large_array::zeroed;

/// The entries of a diagonal, numbers or blocks, all positive definite.
pub(crate) struct Diagonal<E> {
    pub(crate) entries: Vec<E>,
    pub(crate) inverses: Vec<E>,
    /// Where the spectrum of the inverse times the matrix ends, once that is known.
    pub(crate) upper_end: Option<UpperEnd>,
}

impl<E: Entry<Real = f64>> Diagonal<E> {
    /// Of the operator of a level, 0 the coarsest.
    ///
    /// # Errors
    /// [`Error::Diagonal`] at the first entry that is missing or not positive definite.
    pub(crate) fn new(operator: &impl Operator<E>, level: usize) -> Result<Self, Error> {
        let entries = operator.diagonal();
        let mut inverses: Vec<E> = zeroed(entries.len());
        let chunks = map_chunks(&mut inverses, |first, inverses| {
            for (row, (entry, inverse)) in (first..).zip(entries[first..].iter().zip(inverses)) {
                let fault = |value| Error::Diagonal { level, row, value };
                *inverse = entry.inverse().map_err(fault)?;
            }
            Ok(())
        });
        chunks.into_iter().collect::<Result<(), _>>()?;
        Ok(Self { entries, inverses, upper_end: None })
    }

    /// Where the spectrum of the inverse times its matrix ends: looked for once.
    pub(crate) fn find_upper_end(&mut self, matrix: &Csr<E>) -> UpperEnd {
        let find = || largest_eigenvalue(matrix, &self.entries, &self.inverses);
        *self.upper_end.get_or_insert_with(find)
    }

    /// Without what lies off the diagonal inside blocks, if points are asked for.
    /// Constrained rows keep their blocks: else the smoother would leave the free
    /// directions.
    pub(crate) fn of_kind(mut self, kind: DiagonalKind, projectors: &Projectors<E>) -> Self {
        if kind == DiagonalKind::Point && E::SIZE > 1 {
            self.upper_end = None;
            for row in (0..self.entries.len()).filter(|row| projectors.get(*row).is_none()) {
                let block = self.entries[row];
                let on = |i: usize, j: usize, value: f64| if i == j { value } else { 0.0 };
                self.entries[row] = E::from_fn(|i, j| on(i, j, block.at(i, i)));
                self.inverses[row] = E::from_fn(|i, j| on(i, j, 1.0 / block.at(i, i)));
            }
        }
        self
    }

    /// Plus, at each place of the diagonal, the absolute values of what else is in
    /// the row; in constrained rows the largest such sum, to keep free directions.
    pub(crate) fn plus_rows(
        self,
        matrix: &Csr<E>,
        kind: DiagonalKind,
        projectors: &Projectors<E>,
    ) -> Self {
        let mut plain = self.of_kind(kind, projectors);
        plain.upper_end = None;
        for row in 0..matrix.rows() {
            let kept = plain.entries[row];
            let (columns, values) = matrix.row(row);
            let rest = |i: usize| {
                let sum = columns.iter().zip(values).map(|(&j, value)| {
                    let on_diagonal = j as usize == row;
                    let is_kept = |k: usize| on_diagonal && kept.at(i, k) != 0.0;
                    let numbers = (0..E::SIZE).filter(|k| !is_kept(*k));
                    numbers.map(|k| value.at(i, k).abs()).sum::<f64>()
                });
                sum.sum::<f64>()
            };
            let sums: Vec<f64> = (0..E::SIZE).map(rest).collect();
            let largest = sums.iter().copied().fold(0.0, f64::max);
            let sum = |i: usize| if projectors.get(row).is_some() { largest } else { sums[i] };
            let entry = E::from_fn(|i, j| kept.at(i, j) + if i == j { sum(i) } else { 0.0 });
            plain.entries[row] = entry;
            // Larger than a positive definite entry, so positive definite too.
            plain.inverses[row] = entry.inverse().unwrap_or(plain.inverses[row]);
        }
        plain
    }
}
