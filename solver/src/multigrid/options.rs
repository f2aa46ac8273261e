//! How the multigrid cycle smooths, in which shape and in which precision.

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
        /// which is 1.05 times the estimated largest eigenvalue of D⁻¹A, or where
        /// a bound for it is smaller, that bound.
        lower: f64,
    },
    /// A Gauss–Seidel sweep, forward before the coarse correction, backward
    /// after it; of a matrix of blocks, a block at a time. Serial: a reference,
    /// not meant for speed.
    GaussSeidel,
    /// A Gauss–Seidel sweep in the order of a greedy colouring: rows of one colour
    /// are not coupled and done in parallel. Good where colours are few, as with
    /// linear prolongation; costs a pass over x for each colour.
    ColouredGaussSeidel,
    /// A Gauss–Seidel sweep within domains of thousands of neighbouring rows; from each
    /// other they take the values before the sweep (Baker, Falgout, Kolev and Yang
    /// 2011), with a larger diagonal where that is too little to converge. Forward before
    /// the coarse correction, backward after it, a block at a time. Parallel, the same
    /// bits for any number of threads.
    ///
    /// A sweep reads half of the matrix and leaves the residual: a cycle moves about a
    /// quarter of the bytes of one with [`CHEBYSHEV`](Self::CHEBYSHEV). A level of less
    /// than some 4,000 rows is one domain, so serial. Domains are good where neighbours
    /// on the coarsest level are numbered near each other, as along a Hilbert curve.
    HybridGaussSeidel,
    /// x ← x + D⁻¹ (b − A x), D the diagonal plus the absolute values of the rest
    /// of the row (Baker, Falgout, Kolev and Yang 2011): converges for every
    /// positive definite matrix without any estimate, if slowly.
    L1Jacobi,
}

impl Smoother {
    /// Degree 3 on the upper nine tenths of the interval.
    pub const CHEBYSHEV: Self = Self::chebyshev(3);

    /// A polynomial of another degree on the upper nine tenths.
    pub const fn chebyshev(degree: usize) -> Self {
        Self::Chebyshev { degree, lower: 0.1 }
    }
}

/// Which diagonal a smoother of a matrix of blocks inverts; of a matrix of numbers
/// both are the same. Gauss–Seidel always solves blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DiagonalKind {
    /// Numbers on the diagonal.
    Point,
    /// 3 × 3 blocks.
    Block,
}

/// How often a cycle visits the coarser levels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleShape {
    /// Once.
    V,
    /// Twice from each level.
    W,
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

/// The choices of a cycle. The defaults suit the systems of finite
/// elements; nobody has to choose.
///
/// `S` is the smoother and `P` the precision: asked for or left open, or, once the matrix is
/// known ([`ResolvedOptions`]), those that run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MultigridOptions<S = Option<Smoother>, P = Option<Precision>> {
    /// What one sweep is. If left open, what takes the least time:
    /// [`HybridGaussSeidel`](Smoother::HybridGaussSeidel) for a matrix of blocks whose
    /// diagonal is inverted by blocks, else [`CHEBYSHEV`](Smoother::CHEBYSHEV).
    pub smoother: S,
    /// Which diagonal it inverts.
    pub diagonal: DiagonalKind,
    /// How often coarser levels are visited.
    pub shape: CycleShape,
    /// Sweeps before the coarse correction (ν₁).
    pub before: usize,
    /// Sweeps after it (ν₂). With as many as before, the cycle is symmetric; else
    /// conjugate gradients run in their flexible form, which costs a vector more.
    pub after: usize,
    /// The precision inside the cycle; the coarsest level is always solved in double. If
    /// left open, [`Single`](Precision::Single), but [`Double`](Precision::Double) where the
    /// largest entry of the matrix' diagonal is 10⁵ times the smallest: stiff parts then
    /// move as rigid ones, and what little energy soft neighbours put into that would be
    /// lost among the rounding errors of the stiff.
    pub precision: P,
}

/// The choices of a cycle that has been set up.
pub type ResolvedOptions = MultigridOptions<Smoother, Precision>;

/// From this contrast on single precision does not do.
const CONTRAST: f64 = 1e5;

impl Default for MultigridOptions {
    /// V(1,1), the smoother that takes the least time with the diagonal's blocks, single
    /// precision where that does.
    fn default() -> Self {
        Self {
            smoother: None,
            diagonal: DiagonalKind::Block,
            shape: CycleShape::V,
            before: 1,
            after: 1,
            precision: None,
        }
    }
}

impl MultigridOptions {
    /// With the smoother and the precision that run, for a matrix of blocks or of numbers
    /// with this contrast of its diagonal.
    ///
    /// # Errors
    /// [`Error::Option`] for a value that makes no sense.
    pub(crate) fn resolved(
        self,
        has_blocks: bool,
        contrast: f64,
    ) -> Result<ResolvedOptions, Error> {
        let Self { smoother, diagonal, shape, before, after, precision } = self;
        let usual = match has_blocks && diagonal == DiagonalKind::Block {
            true => Smoother::HybridGaussSeidel,
            false => Smoother::CHEBYSHEV,
        };
        let smoother = smoother.unwrap_or(usual);
        let does = if contrast < CONTRAST { Precision::Single } else { Precision::Double };
        let precision = precision.unwrap_or(does);
        let resolved = MultigridOptions { smoother, diagonal, shape, before, after, precision };
        resolved.check()?;
        Ok(resolved)
    }
}

impl ResolvedOptions {
    /// Products with the matrix in one visit of a level, that of the residual included.
    pub(crate) fn products(&self) -> usize {
        let sweeps = self.before + self.after;
        match self.smoother {
            Smoother::Chebyshev { degree, .. } => degree * sweeps + 1,
            // Sweeps leave the residual.
            Smoother::HybridGaussSeidel => sweeps,
            Smoother::GaussSeidel | Smoother::ColouredGaussSeidel | Smoother::L1Jacobi => {
                sweeps + 1
            }
        }
    }

    /// How often a cycle visits the level that lies `below` levels under the finest.
    pub(crate) fn visits(&self, below: usize) -> usize {
        match self.shape {
            CycleShape::V => 1,
            // There are few levels, but the list comes from outside.
            CycleShape::W => 1 << below.min(usize::BITS as usize - 1),
        }
    }

    /// Whether the cycle is symmetric in the energy product.
    pub(crate) fn is_symmetric(&self) -> bool {
        self.before == self.after
    }

    fn check(&self) -> Result<(), Error> {
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
