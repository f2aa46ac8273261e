//! Chebyshev smoothing: a polynomial in D⁻¹A, small on the upper spectrum.
//!
//! Saad, "Iterative methods for sparse linear systems", algorithm 12.1, with
//! the residual, the diagonal scaling and the update inside the product's loop:
//! one pass over the matrix a step. In the energy product the polynomial is
//! symmetric, so the cycle is.

use crate::krylov::operator::Operator;
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::kernels::ChebyshevStep;
use crate::sparse::real::Real;
use octruss_base::chunks::map_chunks2;
use octruss_base::large_array::zeroed;

/// The coefficients of the recurrence d ← keep d + add D⁻¹ r for each step.
#[derive(Debug, Clone)]
pub(crate) struct Chebyshev<E: Entry> {
    steps: Vec<(E::Real, E::Real)>,
    direction: Vec<E::Nodal>,
    next: Vec<E::Nodal>,
}

impl<E: Entry> Chebyshev<E> {
    /// The polynomial of `degree` that is smallest on [`lower`, `upper`].
    pub(crate) fn new(unknowns: usize, degree: usize, lower: f64, upper: f64) -> Self {
        let (centre, radius) = (0.5 * (upper + lower), 0.5 * (upper - lower));
        let sigma = centre / radius;
        let mut rho = 1.0 / sigma;
        let mut steps = vec![(0.0, 1.0 / centre)];
        for _ in 1..degree {
            let previous = rho;
            rho = 1.0 / (2.0 * sigma - previous);
            steps.push((rho * previous, 2.0 * rho / radius));
        }
        let round = |(keep, add)| (E::Real::from_f64(keep), E::Real::from_f64(add));
        Self {
            steps: steps.into_iter().map(round).collect(),
            direction: zeroed(unknowns),
            next: zeroed(unknowns),
        }
    }

    /// The single step d = D⁻¹ r: Jacobi's, for a diagonal that needs no damping.
    pub(crate) fn plain(unknowns: usize) -> Self {
        let step = (E::Real::from_f64(0.0), E::Real::from_f64(1.0));
        Self { steps: vec![step], direction: zeroed(unknowns), next: zeroed(unknowns) }
    }

    /// Steps of a sweep.
    pub(crate) fn degree(&self) -> usize {
        self.steps.len()
    }

    /// Improves `x` for A x = b. With `from_zero`, `x` counts as zero whatever
    /// it holds, and the first step needs no product.
    pub(crate) fn smooth(
        &mut self,
        matrix: &impl Operator<E>,
        inverse_diagonal: &[E],
        (b, x): (&[E::Nodal], &mut Vec<E::Nodal>),
        from_zero: bool,
    ) {
        for (step, &(keep, add)) in self.steps.iter().enumerate() {
            if step == 0 && from_zero {
                start::<E>(add, (inverse_diagonal, b), &mut self.direction, x);
                continue;
            }
            let (d, next) = (&mut self.direction[..], &mut self.next[..]);
            matrix.chebyshev_step(ChebyshevStep { inverse_diagonal, keep, add, b, x, d, next });
            std::mem::swap(x, &mut self.next);
        }
    }

    /// The memory of its vectors, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        2 * size_of_val(&*self.next)
    }
}

/// The first step from zero: d = x = add D⁻¹ b.
fn start<E: Entry>(
    add: E::Real,
    (inverse_diagonal, b): (&[E], &[E::Nodal]),
    d: &mut [E::Nodal],
    x: &mut [E::Nodal],
) {
    map_chunks2(d, x, |first, d, x| {
        for (k, (d, x)) in d.iter_mut().zip(x).enumerate() {
            let scaled = inverse_diagonal[first + k].add_product(b[first + k], E::Nodal::default());
            *d = scaled.scaled(add);
            *x = *d;
        }
    });
}
