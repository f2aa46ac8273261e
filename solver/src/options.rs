//! How the multigrid cycle smooths and in which precision.

use crate::error::Error;

/// What one smoothing sweep is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Smoother {
    /// A Chebyshev polynomial in D⁻¹A: parallel, the same bits for any number
    /// of threads.
    Chebyshev {
        /// Products with the matrix a sweep.
        degree: usize,
        /// The lower end of the damped interval as a share of its upper end,
        /// which is 1.1 times the estimated largest eigenvalue of D⁻¹A.
        lower: f64,
    },
    /// A Gauss–Seidel sweep, forward before the coarse correction, backward
    /// after it. Serial: a reference, not meant for speed.
    GaussSeidel,
}

/// The precision of matrices and vectors inside the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// Half the bytes; under conjugate gradients in double precision the
    /// iterations stay the same.
    Single,
    /// For use without conjugate gradients to full accuracy, and for tests.
    Double,
}

/// The choices of a V-cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MultigridOptions {
    /// What one sweep is.
    pub smoother: Smoother,
    /// Sweeps before the coarse correction (ν₁).
    pub before: usize,
    /// Sweeps after it (ν₂). As a preconditioner of conjugate gradients the
    /// cycle must be symmetric: as many as before.
    pub after: usize,
    /// The precision inside the cycle; the coarsest level is always solved in double.
    pub precision: Precision,
}

impl Default for MultigridOptions {
    /// V(1,1), Chebyshev of degree 3 on the upper nine tenths, single precision.
    fn default() -> Self {
        Self {
            smoother: Smoother::Chebyshev { degree: 3, lower: 0.1 },
            before: 1,
            after: 1,
            precision: Precision::Single,
        }
    }
}

impl MultigridOptions {
    /// Products with the matrix that smoothing takes in one cycle.
    pub(crate) fn smoothing_products(&self) -> usize {
        let sweeps = self.before + self.after;
        match self.smoother {
            Smoother::Chebyshev { degree, .. } => degree * sweeps,
            Smoother::GaussSeidel => sweeps,
        }
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        if self.before + self.after == 0 {
            let expected = "at least one smoothing sweep";
            return Err(Error::Option { option: "before, after", expected });
        }
        if let Smoother::Chebyshev { degree, lower } = self.smoother {
            if degree == 0 {
                return Err(Error::Option { option: "degree", expected: "at least 1" });
            }
            if !(lower > 0.0 && lower < 1.0) {
                return Err(Error::Option { option: "lower", expected: "between 0 and 1" });
            }
        }
        Ok(())
    }
}
