//! The near-null space of one level, row by row.

use crate::error::{Error, check_finite, check_size};
use crate::multigrid::aggregation::near_null_space::NearNullSpace;
use crate::multigrid::projectors::Projectors;
use crate::sparse::entry::Entry;

/// Vectors without energy: of each row so many entries as there are block columns, each
/// with [`Entry::SIZE`] vectors.
#[derive(Clone)]
pub(crate) struct Candidates<E> {
    pub(crate) columns: usize,
    pub(crate) values: Vec<E>,
}

impl<E: Entry<Real = f64>> Candidates<E> {
    /// Those of the coarsest given level with so many rows, in their free directions.
    ///
    /// # Errors
    /// [`Error::Size`] unless there is a position for each row; [`Error::NotFinite`];
    /// [`Error::Option`] for rigid motions of a matrix of numbers.
    pub(crate) fn new(
        space: &NearNullSpace,
        rows: usize,
        projectors: &Projectors<E>,
    ) -> Result<Self, Error> {
        let mut all = match space {
            NearNullSpace::Constants | NearNullSpace::Unknown => {
                Self { columns: 1, values: vec![E::identity(); rows] }
            }
            NearNullSpace::RigidMotions(positions) => {
                if E::SIZE != 3 {
                    let expected = "constants for a matrix of numbers";
                    return Err(Error::Option { option: "near_null_space", expected });
                }
                check_size("positions of the near-null space", positions.len(), rows)?;
                check_finite("positions of the near-null space", positions.as_flattened())?;
                Self { columns: 2, values: rigid_motions(positions) }
            }
        };
        for (row, entries) in all.values.chunks_exact_mut(all.columns).enumerate() {
            if let Some(projector) = projectors.get(row) {
                entries.iter_mut().for_each(|entry| *entry = projector.times(*entry));
            }
        }
        Ok(all)
    }

    /// The entries of a row.
    pub(crate) fn row(&self, row: usize) -> &[E] {
        &self.values[row * self.columns..(row + 1) * self.columns]
    }
}

/// Translations, and rotations about the centre, in units of the size of the body.
fn rigid_motions<E: Entry>(positions: &[[f64; 3]]) -> Vec<E> {
    let count = positions.len().max(1) as f64;
    let centre: [f64; 3] =
        std::array::from_fn(|k| positions.iter().map(|p| p[k]).sum::<f64>() / count);
    let arm = |p: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| p[k] - centre[k]) };
    let size = positions.iter().flat_map(arm).map(f64::abs).fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let motions = |p: &[f64; 3]| {
        let [x, y, z] = arm(p).map(|a| a / size);
        // Columns are e_k × (x, y, z).
        let turn = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]];
        [E::identity(), E::from_fn(|i, j| turn[i][j])]
    };
    positions.iter().flat_map(motions).collect()
}
