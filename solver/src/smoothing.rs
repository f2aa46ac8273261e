//! The smoother of one level, whichever it is.

use crate::chebyshev::Chebyshev;
use crate::colouring::Colouring;
use crate::csr::Csr;
use crate::diagonal::Diagonal;
use crate::entry::Entry;
use crate::gauss_seidel::{Order, coloured_sweep, sweep};
use crate::options::{MultigridOptions, Smoother};
use crate::projectors::Projectors;
use crate::spectrum::largest_eigenvalue;

/// The estimated largest eigenvalue is from below; the damped interval ends
/// this much higher.
const SAFETY: f64 = 1.1;

/// A smoother with its data and work vectors.
pub(crate) struct Smoothing<E: Entry> {
    inverse_diagonal: Vec<E>,
    kind: Kind<E>,
    /// The estimate for D⁻¹A, where the smoother needs one.
    pub(crate) largest_eigenvalue: Option<f64>,
}

enum Kind<E: Entry> {
    Polynomial(Chebyshev<E>),
    Lexicographic,
    Coloured(Colouring, Vec<E::Nodal>),
}

impl<E: Entry> Smoothing<E> {
    /// The smoother of `scale` times a matrix in double precision.
    pub(crate) fn new<D: Entry<Real = f64>>(
        (matrix, diagonal, projectors): (&Csr<D>, Diagonal<D>, &Projectors<D>),
        scale: f64,
        options: &MultigridOptions,
    ) -> Self {
        let n = matrix.rows();
        let mut eigenvalue = None;
        let (diagonal, kind) = match options.smoother {
            Smoother::Chebyshev { degree, lower } => {
                let diagonal = diagonal.of_kind(options.diagonal, projectors);
                let largest = largest_eigenvalue(matrix, &diagonal.entries, &diagonal.inverses);
                eigenvalue = Some(largest);
                let upper = SAFETY * largest;
                (diagonal, Kind::Polynomial(Chebyshev::new(n, degree, lower * upper, upper)))
            }
            Smoother::L1Jacobi => {
                let diagonal = diagonal.plus_rows(matrix, options.diagonal, projectors);
                (diagonal, Kind::Polynomial(Chebyshev::plain(n)))
            }
            Smoother::GaussSeidel => (diagonal, Kind::Lexicographic),
            Smoother::ColouredGaussSeidel => {
                let colouring = Colouring::greedy(matrix);
                let buffer = vec![E::Nodal::default(); colouring.largest()];
                (diagonal, Kind::Coloured(colouring, buffer))
            }
        };
        let rounded = diagonal.inverses.iter().map(|d| d.cast_scaled(1.0 / scale)).collect();
        Self { inverse_diagonal: rounded, kind, largest_eigenvalue: eigenvalue }
    }

    /// One sweep for A x = b. With `from_zero`, `x` counts as zero whatever it holds.
    pub(crate) fn sweep(
        &mut self,
        matrix: &Csr<E>,
        (b, x): (&[E::Nodal], &mut Vec<E::Nodal>),
        order: Order,
        from_zero: bool,
    ) {
        let inverse_diagonal = &self.inverse_diagonal;
        if from_zero && !matches!(self.kind, Kind::Polynomial(_)) {
            x.fill(E::Nodal::default());
        }
        match &mut self.kind {
            Kind::Polynomial(chebyshev) => {
                chebyshev.smooth(matrix, inverse_diagonal, (b, x), from_zero);
            }
            Kind::Lexicographic => sweep(matrix, inverse_diagonal, b, x, order),
            Kind::Coloured(colouring, buffer) => {
                let rows = (&*colouring, &mut **buffer);
                coloured_sweep((matrix, inverse_diagonal), rows, (b, x), order);
            }
        }
    }

    /// The memory of its data and work vectors, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let kind = match &self.kind {
            Kind::Polynomial(chebyshev) => chebyshev.bytes(),
            Kind::Lexicographic => 0,
            Kind::Coloured(colouring, buffer) => colouring.bytes() + size_of_val(&**buffer),
        };
        size_of_val(&*self.inverse_diagonal) + kind
    }

    /// Passes over the matrix in a sweep that does not begin at zero.
    pub(crate) fn products(&self) -> usize {
        match &self.kind {
            Kind::Polynomial(chebyshev) => chebyshev.degree(),
            Kind::Lexicographic | Kind::Coloured(..) => 1,
        }
    }
}
