//! One smoothed level of the multigrid: plain data and the steps of the cycle.

use crate::chebyshev::Chebyshev;
use crate::csr::Csr;
use crate::gauss_seidel::{Order, sweep};
use crate::kernels::{add_product, product, residual};
use crate::options::{MultigridOptions, Smoother};
use crate::real::Real;

/// The estimated largest eigenvalue is from below; the damped interval ends
/// this much higher.
const SAFETY: f64 = 1.1;

/// A matrix, its smoother, the transfer to the next coarser level and the work
/// vectors of both, allocated once.
pub(crate) struct Level<T> {
    matrix: Csr<T>,
    inverse_diagonal: Vec<T>,
    /// `None` for Gauss–Seidel, which has no data of its own.
    chebyshev: Option<Chebyshev<T>>,
    before: usize,
    after: usize,
    prolongation: Csr<T>,
    restriction: Csr<T>,
    residual: Vec<T>,
    /// Right-hand side and solution of the next coarser level.
    pub(crate) coarse_rhs: Vec<T>,
    pub(crate) coarse_x: Vec<T>,
}

impl<T: Real> Level<T> {
    /// A level of `scale` times a matrix in double precision; `eigenvalue` is the
    /// estimate for D⁻¹A, which no scale changes.
    pub(crate) fn new(
        (matrix, diagonal, scale): (&Csr<f64>, &[f64], f64),
        eigenvalue: f64,
        (prolongation, restriction): (&Csr<f64>, &Csr<f64>),
        options: &MultigridOptions,
    ) -> Self {
        let chebyshev = match options.smoother {
            Smoother::Chebyshev { degree, lower } => {
                let upper = SAFETY * eigenvalue;
                Some(Chebyshev::new(matrix.rows(), degree, lower * upper, upper))
            }
            Smoother::GaussSeidel => None,
        };
        Self {
            matrix: matrix.cast_scaled(scale),
            inverse_diagonal: diagonal.iter().map(|d| T::from_f64(1.0 / (scale * d))).collect(),
            chebyshev,
            before: options.before,
            after: options.after,
            prolongation: prolongation.cast(),
            restriction: restriction.cast(),
            residual: vec![T::default(); matrix.rows()],
            coarse_rhs: vec![T::default(); prolongation.columns()],
            coarse_x: vec![T::default(); prolongation.columns()],
        }
    }

    /// x = what the sweeps before the correction make of zero.
    pub(crate) fn smooth_before(&mut self, b: &[T], x: &mut Vec<T>) {
        if self.before == 0 || self.chebyshev.is_none() {
            x.fill(T::default());
        }
        self.smooth(self.before, Order::Forward, b, x, true);
    }

    /// The sweeps after the correction.
    pub(crate) fn smooth_after(&mut self, b: &[T], x: &mut Vec<T>) {
        self.smooth(self.after, Order::Backward, b, x, false);
    }

    fn smooth(&mut self, sweeps: usize, order: Order, b: &[T], x: &mut Vec<T>, from_zero: bool) {
        for k in 0..sweeps {
            match &mut self.chebyshev {
                Some(chebyshev) => {
                    let from_zero = from_zero && k == 0;
                    chebyshev.smooth(&self.matrix, &self.inverse_diagonal, (b, x), from_zero);
                }
                None => sweep(&self.matrix, &self.inverse_diagonal, b, x, order),
            }
        }
    }

    /// The coarse right-hand side: Pᵀ (b − A x).
    pub(crate) fn restrict_residual(&mut self, b: &[T], x: &[T]) {
        residual(&self.matrix, x, b, &mut self.residual);
        product(&self.restriction, &self.residual, &mut self.coarse_rhs);
    }

    /// x += P times the coarse solution.
    pub(crate) fn correct(&self, x: &mut [T]) {
        add_product(&self.prolongation, &self.coarse_x, x);
    }

    /// The memory of matrices and work vectors, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let matrices = [&self.matrix, &self.prolongation, &self.restriction];
        let vectors = [&self.inverse_diagonal, &self.residual, &self.coarse_rhs, &self.coarse_x];
        matrices.iter().map(|m| m.bytes()).sum::<usize>()
            + vectors.iter().map(|v| size_of_val(v.as_slice())).sum::<usize>()
            + self.chebyshev.as_ref().map_or(0, Chebyshev::bytes)
    }
}
