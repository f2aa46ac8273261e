//! The smoothers that go through whole rows of a level's matrix.

use crate::krylov::lanczos::largest_eigenvalue;
use crate::krylov::operator::Operator;
use crate::multigrid::smoother::chebyshev::Chebyshev;
use crate::multigrid::smoother::colouring::Colouring;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::multigrid::smoother::gauss_seidel::{Order, coloured_sweep, sweep};
use crate::sparse::csr::{Csr, cast_all};
use crate::sparse::entry::Entry;

/// The estimated largest eigenvalue is from below by a few percent; the damped
/// interval ends this much higher, unless a bound says that it need not. (Just
/// beyond its end a Chebyshev polynomial still damps.)
const SAFETY: f64 = 1.05;

/// A matrix and its smoother with its data and work vectors.
pub(crate) struct RowSmoother<E: Entry> {
    matrix: Csr<E>,
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

/// A matrix with what a smoother divides by: double precision, and what it is to be
/// multiplied by before it is rounded to the cycle's.
pub(crate) type Scaled<'a, D> = (&'a Csr<D>, Diagonal<D>, f64);

impl<E: Entry> RowSmoother<E> {
    fn new<D: Entry<Real = f64>>((matrix, diagonal, scale): Scaled<D>, kind: Kind<E>) -> Self {
        Self {
            matrix: matrix.cast_scaled(scale),
            inverse_diagonal: cast_all(&diagonal.inverses, 1.0 / scale),
            kind,
            largest_eigenvalue: None,
        }
    }

    /// Chebyshev polynomials on the share of the spectrum above `lower`.
    pub(crate) fn chebyshev<D: Entry<Real = f64>>(
        (matrix, diagonal, scale): Scaled<D>,
        (degree, lower): (usize, f64),
    ) -> Self {
        let (known, entries) = (diagonal.upper_end, cast_all(&diagonal.entries, scale));
        let mut smoother = Self::new((matrix, diagonal, scale), Kind::Lexicographic);
        let find = || largest_eigenvalue(&smoother.matrix, &entries, &smoother.inverse_diagonal);
        let end = known.unwrap_or_else(find);
        let upper = (SAFETY * end.estimate).min(end.bound);
        let polynomial = Chebyshev::new(matrix.rows(), degree, lower * upper, upper);
        smoother.kind = Kind::Polynomial(polynomial);
        smoother.largest_eigenvalue = Some(end.estimate);
        smoother
    }

    /// Jacobi's step with a diagonal that needs no damping.
    pub(crate) fn jacobi<D: Entry<Real = f64>>(scaled: Scaled<D>) -> Self {
        let polynomial = Chebyshev::plain(scaled.0.rows());
        Self::new(scaled, Kind::Polynomial(polynomial))
    }

    /// Gauss–Seidel, a row after the other.
    pub(crate) fn gauss_seidel<D: Entry<Real = f64>>(scaled: Scaled<D>) -> Self {
        Self::new(scaled, Kind::Lexicographic)
    }

    /// Gauss–Seidel, a colour after the other; the colours may be known.
    pub(crate) fn coloured<D: Entry<Real = f64>>(
        scaled: Scaled<D>,
        known: Option<Colouring>,
    ) -> Self {
        let colouring = known.unwrap_or_else(|| Colouring::greedy(scaled.0));
        let buffer = vec![E::Nodal::default(); colouring.largest()];
        Self::new(scaled, Kind::Coloured(colouring, buffer))
    }

    /// The colours of the rows, where they have some.
    pub(crate) fn into_colouring(self) -> Option<Colouring> {
        match self.kind {
            Kind::Coloured(colouring, _) => Some(colouring),
            Kind::Polynomial(_) | Kind::Lexicographic => None,
        }
    }

    /// One sweep for A x = b. With `from_zero`, `x` counts as zero whatever it holds.
    pub(crate) fn sweep(
        &mut self,
        (b, x): (&[E::Nodal], &mut Vec<E::Nodal>),
        order: Order,
        from_zero: bool,
    ) {
        let (matrix, inverse_diagonal) = (&self.matrix, &self.inverse_diagonal);
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

    /// The residual r = b − A x.
    pub(crate) fn residual(&self, b: &[E::Nodal], x: &[E::Nodal], r: &mut [E::Nodal]) {
        Operator::residual(&self.matrix, x, b, r);
    }

    /// The memory of its data and work vectors, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let kind = match &self.kind {
            Kind::Polynomial(chebyshev) => chebyshev.bytes(),
            Kind::Lexicographic => 0,
            Kind::Coloured(colouring, buffer) => colouring.bytes() + size_of_val(&**buffer),
        };
        self.matrix.bytes() + size_of_val(&*self.inverse_diagonal) + kind
    }

    /// The bytes that one sweep moves, from the sizes of its arrays.
    /// From zero a polynomial saves its first product.
    fn sweep_bytes(&self, from_zero: bool) -> usize {
        let matrix = &self.matrix;
        let (diagonal, vector) =
            (size_of_val(&*self.inverse_diagonal), matrix.rows() * size_of::<E::Nodal>());
        match &self.kind {
            Kind::Polynomial(chebyshev) => {
                // Reads x, b and d, writes d and the next x; the first step from
                // zero reads b and writes d and x.
                let step = matrix.bytes() + diagonal + 5 * vector;
                let first = if from_zero { diagonal + 3 * vector } else { step };
                first + (chebyshev.degree() - 1) * step
            }
            Kind::Lexicographic => matrix.bytes() + diagonal + 3 * vector,
            Kind::Coloured(colouring, _) => {
                matrix.bytes() + diagonal + 5 * vector + colouring.bytes()
            }
        }
    }

    /// The bytes that some sweeps move.
    pub(crate) fn sweeps_bytes(&self, count: usize, from_zero: bool) -> usize {
        (0..count).map(|k| self.sweep_bytes(from_zero && k == 0)).sum()
    }

    /// The bytes that a residual moves.
    pub(crate) fn residual_bytes(&self) -> usize {
        self.matrix.bytes() + 3 * self.matrix.rows() * size_of::<E::Nodal>()
    }
}
