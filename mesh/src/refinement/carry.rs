//! Carrying fields onto a finer mesh, within the range of their stencils if so
//! asked.

use rayon::prelude::*;

use crate::refinement::subdivision_matrix::SubdivisionMatrix;
use octruss_base::ragged::CHUNK;

/// What becomes of a value that leaves the range of the values it is made from,
/// as rows with negative weights allow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Overshoot {
    /// It stays, and polynomials are reproduced.
    #[default]
    Allow,
    /// It becomes the nearer end of the range, for each component by itself.
    Clamp,
}

/// A field on a finer mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Carried {
    /// One tuple a row, tuple after tuple.
    pub values: Vec<f64>,
    /// How many values were clamped, those off by rounding alone not counted.
    pub clamped: usize,
}

/// Applies a subdivision step to a field with `components` values a vertex.
///
/// A value that is no number spreads to every row that reads it.
///
/// # Panics
/// If `coarse` does not have `components` values for each column.
pub fn carry_field(
    matrix: &SubdivisionMatrix,
    coarse: &[f64],
    components: usize,
    overshoot: Overshoot,
) -> Carried {
    let mut values = matrix.apply_field(coarse, components);
    if overshoot == Overshoot::Allow || components == 0 {
        return Carried { values, clamped: 0 };
    }
    let clamp_row = |(row, tuple): (usize, &mut [f64])| {
        let (columns, weights) = matrix.row(row);
        let stencil = columns.iter().zip(weights).map(|(&column, &weight)| {
            (weight, &coarse[components * column as usize..][..components])
        });
        clamp(tuple, stencil)
    };
    let rows = values.par_chunks_mut(components).with_min_len(CHUNK).enumerate();
    let clamped = rows.map(clamp_row).sum();
    Carried { values, clamped }
}

/// Brings each component of a tuple into the range of the stencil's, weights of
/// zero left out; returns how many it moved by more than rounding.
pub(crate) fn clamp<'a>(
    tuple: &mut [f64],
    stencil: impl Iterator<Item = (f64, &'a [f64])> + Clone,
) -> usize {
    let mut moved = 0;
    for (component, value) in tuple.iter_mut().enumerate() {
        let read = stencil.clone().filter(|&(weight, _)| weight != 0.0);
        let [low, high] = read
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], (_, from)| {
                [low.min(from[component]), high.max(from[component])]
            });
        // Comparisons leave a value alone that is no number.
        let nearest = match *value {
            v if v < low => low,
            v if v > high => high,
            v => v,
        };
        let rounding = 1e-12 * low.abs().max(high.abs());
        moved += usize::from((nearest - *value).abs() > rounding);
        *value = nearest;
    }
    moved
}
