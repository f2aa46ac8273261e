//! Eigenvalues by decreasing modulus.

use std::cmp::Ordering;

use nalgebra::{DMatrix, linalg::Schur};

use super::error::AnalysisError;

/// Moduli that differ by less count as equal.
const TOLERANCE: f64 = 1e-9;
/// Larger than the modulus of any eigenvalue, which a row sum of weights bounds.
const SHIFT: f64 = 2.0;
/// What the iteration takes for zero, beside the diagonal. Multiple eigenvalues
/// without as many eigenvectors keep it from going further; they are then right
/// to the square root of this.
const DROPPED: [f64; 3] = [1e-13, 1e-12, 1e-11];

/// The eigenvalues of a local matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Real and imaginary parts, by decreasing modulus; conjugates beside each
    /// other, the one with positive imaginary part first.
    pub eigenvalues: Vec<[f64; 2]>,
}

impl Spectrum {
    /// # Errors
    /// If the iteration does not end.
    pub(crate) fn new(matrix: &DMatrix<f64>) -> Result<Self, AnalysisError> {
        let size = matrix.nrows();
        let steps = 30 * size;
        // The iteration drops an entry that is small beside the diagonal; the
        // shift keeps the diagonal of the many small eigenvalues off zero.
        let shifted = matrix + DMatrix::identity(size, size) * SHIFT;
        let schur = DROPPED
            .iter()
            .find_map(|&eps| Schur::try_new(shifted.clone(), eps, steps))
            .ok_or(AnalysisError::Eigenvalues { size, steps })?;
        let values = schur.complex_eigenvalues();
        let mut eigenvalues: Vec<[f64; 2]> = values.iter().map(|z| [z.re - SHIFT, z.im]).collect();
        eigenvalues.sort_by(by_modulus);
        Ok(Self { eigenvalues })
    }

    /// The modulus of eigenvalue `i`; 0 beyond the last.
    pub fn modulus(&self, i: usize) -> f64 {
        self.eigenvalues.get(i).map_or(0.0, |&[re, im]| re.hypot(im))
    }

    /// Whether λ0 = 1 is simple and all others are smaller: subdivision
    /// converges at the vertex.
    pub fn is_convergent(&self) -> bool {
        let [re, im] = self.eigenvalues[0];
        (re - 1.0).abs() < TOLERANCE && im.abs() < TOLERANCE && self.modulus(1) < 1.0 - TOLERANCE
    }

    /// Whether |λ3| > |λ4|: three eigenvectors dominate the shape at the vertex.
    pub fn is_separated(&self) -> bool {
        self.modulus(3) > self.modulus(4) + TOLERANCE
    }
}

fn by_modulus(a: &[f64; 2], b: &[f64; 2]) -> Ordering {
    let modulus = |z: &[f64; 2]| z[0].hypot(z[1]);
    modulus(b).total_cmp(&modulus(a)).then(b[0].total_cmp(&a[0])).then(b[1].total_cmp(&a[1]))
}
