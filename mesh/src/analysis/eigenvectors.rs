//! Eigenvectors of the three eigenvalues after the first.

use nalgebra::{DMatrix, DVector};

use super::no_map::NoMap;
use super::spectrum::Spectrum;

/// Eigenvalues closer than this share one space of eigenvectors.
const SAME: f64 = 1e-7;
/// The shift off an eigenvalue in the inverse iteration, and the residual that
/// an eigenvector may have.
const SHIFT: f64 = 1e-9;
const RESIDUAL: f64 = 1e-6;

/// The eigenvalues λ1, λ2, λ3 and an eigenvector of unit length for each,
/// orthogonal where they share an eigenvalue.
///
/// # Errors
/// If they are not real, not independent, or not separated from λ4.
pub(crate) fn dominant(
    matrix: &DMatrix<f64>,
    spectrum: &Spectrum,
) -> Result<([f64; 3], DMatrix<f64>), NoMap> {
    let values = spectrum.eigenvalues.get(1..4).ok_or(NoMap::TooFew)?;
    if values.iter().any(|z| z[1].abs() > SAME) {
        return Err(NoMap::Complex);
    }
    if !spectrum.is_separated() {
        return Err(NoMap::NotSeparated);
    }
    let values = [values[0][0], values[1][0], values[2][0]];
    let mut vectors = Vec::new();
    for same in values.chunk_by(|a, b| (a - b).abs() < SAME) {
        let mean = same.iter().sum::<f64>() / same.len() as f64;
        let space = eigenspace(matrix, mean, same.len()).ok_or(NoMap::Dependent)?;
        vectors.extend(space.column_iter().map(|column| column.into_owned()));
    }
    Ok((values, DMatrix::from_columns(&vectors)))
}

/// An orthonormal basis of the eigenvectors of a real eigenvalue, of which
/// there should be `count`; by inverse iteration.
fn eigenspace(matrix: &DMatrix<f64>, value: f64, count: usize) -> Option<DMatrix<f64>> {
    let n = matrix.nrows();
    let shifted = matrix - DMatrix::identity(n, n) * (value + SHIFT);
    let solver = shifted.lu();
    // Any start will do that favours no symmetry of the star.
    let mut vectors =
        DMatrix::from_fn(n, count, |i, j| (1.0 + 0.7 * i as f64 + 1.9 * (i * j) as f64).sin());
    for _ in 0..5 {
        vectors = solver.solve(&vectors)?.qr().q();
    }
    let residual = matrix * &vectors - &vectors * value;
    let is_small = |column: DVector<f64>| column.norm() < RESIDUAL;
    residual.column_iter().all(|column| is_small(column.into_owned())).then_some(vectors)
}
