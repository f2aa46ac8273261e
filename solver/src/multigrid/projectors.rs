//! Which directions of constrained rows are free.
//!
//! A constrained row i has an orthogonal projector Q_i onto its free directions;
//! all others have the identity. A constrained matrix is Q A Q + s (I − Q): it
//! leaves vectors in the range of Q there, so only transfers between levels have
//! to project, and only at the rows listed.

use crate::error::{Error, check_size};
use crate::sparse::entry::Entry;

/// The projectors of one level.
pub(crate) struct Projectors<E> {
    /// Ascending by row.
    list: Vec<(u32, E)>,
    /// For each row its place in the list, or `NONE`; empty for an empty list.
    places: Vec<u32>,
}

const NONE: u32 = u32::MAX;

/// How far Q Q and Qᵀ may be from Q.
const TOLERANCE: f64 = 1e-10;

impl<E: Entry<Real = f64>> Projectors<E> {
    /// No row is constrained.
    pub(crate) fn none() -> Self {
        Self { list: Vec::new(), places: Vec::new() }
    }

    /// From (row, projector) of the constrained rows of a level, 0 the coarsest.
    ///
    /// # Errors
    /// [`Error::Size`] if a row is not below `rows`; [`Error::Projector`] if rows do
    /// not ascend or a matrix is no orthogonal projector.
    pub(crate) fn new(level: usize, rows: usize, list: Vec<(u32, E)>) -> Result<Self, Error> {
        let mut places = vec![NONE; if list.is_empty() { 0 } else { rows }];
        for (place, (row, projector)) in (0..).zip(&list) {
            let ascends = place == 0 || list[place as usize - 1].0 < *row;
            let defects = [projector.times(*projector), projector.transposed()];
            let defect = defects.map(|other| other.add_scaled(-1.0, *projector).norm());
            // Written so that NaN is refused.
            if !(ascends && defect.iter().all(|d| *d <= TOLERANCE)) {
                return Err(Error::Projector { level, row: *row });
            }
            match places.get_mut(*row as usize) {
                Some(slot) => *slot = place,
                None => check_size("rows, a projector names one more", rows, *row as usize + 1)?,
            }
        }
        Ok(Self { list, places })
    }

    /// As [`Projectors::new`] for a list that is right by construction.
    pub(crate) fn trusted(rows: usize, list: Vec<(u32, E)>) -> Self {
        let mut places = vec![NONE; if list.is_empty() { 0 } else { rows }];
        (0..).zip(&list).for_each(|(place, (row, _))| places[*row as usize] = place);
        Self { list, places }
    }

    /// Whether no row is constrained.
    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The projector of a row, unless that is the identity.
    #[inline]
    pub(crate) fn get(&self, row: usize) -> Option<&E> {
        let place = *self.places.get(row)?;
        self.list.get(place as usize).map(|(_, projector)| projector)
    }

    /// Q_i · entry · Q_j, and for i = j, where a direction is not free, the size of
    /// the entry in it.
    pub(crate) fn between(&self, (i, j): (usize, usize), entry: E) -> E {
        if self.list.is_empty() {
            return entry;
        }
        let mut projected = entry;
        if let Some(q) = self.get(i) {
            projected = q.times(projected);
        }
        if let Some(q) = self.get(j) {
            projected = projected.times(*q);
        }
        match self.get(i) {
            Some(q) if i == j => {
                let fixed = E::identity().add_scaled(-1.0, *q);
                projected.add_scaled(entry.norm(), fixed)
            }
            _ => projected,
        }
    }

    /// Rounded to the precision of a cycle.
    pub(crate) fn cast<F: Entry>(&self) -> Vec<(u32, F)> {
        self.list.iter().map(|(row, projector)| (*row, projector.cast_scaled(1.0))).collect()
    }
}

/// x ← Q x at the rows listed.
pub fn project<E: Entry>(list: &[(u32, E)], x: &mut [E::Nodal]) {
    for (row, projector) in list {
        let x = &mut x[*row as usize];
        *x = projector.add_product(*x, E::Nodal::default());
    }
}
