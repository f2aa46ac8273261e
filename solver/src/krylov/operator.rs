//! What iterations and smoothers ask of a matrix.

use crate::error::{Error, check_finite, check_size};
use crate::sparse::backward_error::row_sizes;
use crate::sparse::csr::Csr;
use crate::sparse::dot::chunk_dot;
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::kernels::{self, ChebyshevStep};
use octruss_base::chunks::{for_chunks, map_ranges};
use octruss_base::large_array::zeroed;

/// A square linear operator on vectors with a number, or three, for each row.
///
/// Required is what any operator can do; the rest is provided from it, and a [`Csr`]
/// does it in one pass over its entries instead. Iterations and the Chebyshev smoother
/// ask for no more, so nothing but this trait stands between them and an operator whose
/// entries are never stored. (The levels of a [`Multigrid`](crate::Multigrid) have
/// matrices: Galerkin products are made of entries.)
///
/// ```
/// use octruss_solver::{Identity, Operator, SolveOptions, conjugate_gradients};
///
/// /// −u″ on points at distance 1 between two fixed ends.
/// struct SecondDifference(usize);
///
/// impl Operator for SecondDifference {
///     fn rows(&self) -> usize {
///         self.0
///     }
///     fn apply(&self, x: &[f64], y: &mut [f64]) {
///         for i in 0..x.len() {
///             let before = if i > 0 { x[i - 1] } else { 0.0 };
///             y[i] = 2.0 * x[i] - before - x.get(i + 1).unwrap_or(&0.0);
///         }
///     }
///     fn diagonal(&self) -> Vec<f64> {
///         vec![2.0; self.0]
///     }
/// }
///
/// let solved = conjugate_gradients(
///     &SecondDifference(3),
///     &[1.0; 3],
///     &mut Identity,
///     &SolveOptions::default(),
/// );
/// assert!((solved?.0[1] - 2.0).abs() < 1e-8);
/// # Ok::<(), octruss_solver::Error>(())
/// ```
pub trait Operator<E: Entry = f64>: Sync {
    /// The rows, and as many columns.
    fn rows(&self) -> usize;

    /// y = A x.
    fn apply(&self, x: &[E::Nodal], y: &mut [E::Nodal]);

    /// The diagonal, an entry for each row.
    fn diagonal(&self) -> Vec<E>;

    /// r = b − A x.
    fn residual(&self, x: &[E::Nodal], b: &[E::Nodal], r: &mut [E::Nodal]) {
        self.apply(x, r);
        r.iter_mut().zip(b).for_each(|(r, b)| *r = b.minus(*r));
    }

    /// y = A x, and x · y.
    fn product_dot(&self, x: &[E::Nodal], y: &mut [E::Nodal]) -> f64 {
        self.apply(x, y);
        chunk_dot(Nodal::flat(x), Nodal::flat(y))
    }

    /// d ← `keep` d + `add` D⁻¹ (b − A x), next = x + d.
    fn chebyshev_step(&self, step: ChebyshevStep<E>) {
        let ChebyshevStep { inverse_diagonal, keep, add, b, x, d, next } = step;
        self.residual(x, b, next);
        for (((d, next), x), inverse) in d.iter_mut().zip(next).zip(x).zip(inverse_diagonal) {
            let scaled = inverse.add_product(*next, E::Nodal::default());
            *d = d.scaled(keep).add_scaled(add, scaled);
            *next = x.plus(*d);
        }
    }

    /// A number that no eigenvalue of D⁻¹A exceeds, if one is known.
    fn bound(&self, _inverse_diagonal: &[E]) -> Option<f64> {
        None
    }

    /// |A| |x| + |b| for each row, which [`backward_error`](crate::backward_error) measures
    /// residuals by, if entries are known.
    fn row_sizes(&self, _x: &[E::Nodal], _b: &[E::Nodal]) -> Option<Vec<E::Nodal>> {
        None
    }

    /// Whether it can be used at all.
    ///
    /// # Errors
    /// Of a matrix that is not square or not finite.
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }
}

impl<E: Entry> Operator<E> for Csr<E> {
    fn rows(&self) -> usize {
        self.rows()
    }

    fn apply(&self, x: &[E::Nodal], y: &mut [E::Nodal]) {
        kernels::product(self, x, y);
    }

    fn diagonal(&self) -> Vec<E> {
        let mut diagonal: Vec<E> = zeroed(self.rows());
        for_chunks(&mut diagonal, |first, chunk| {
            for (row, entry) in (first..).zip(chunk) {
                *entry = self.get(row, row).unwrap_or_default();
            }
        });
        diagonal
    }

    fn residual(&self, x: &[E::Nodal], b: &[E::Nodal], r: &mut [E::Nodal]) {
        kernels::residual(self, x, b, r);
    }

    fn product_dot(&self, x: &[E::Nodal], y: &mut [E::Nodal]) -> f64 {
        kernels::product_dot(self, x, y)
    }

    fn chebyshev_step(&self, step: ChebyshevStep<E>) {
        kernels::chebyshev_step(self, step);
    }

    fn row_sizes(&self, x: &[E::Nodal], b: &[E::Nodal]) -> Option<Vec<E::Nodal>> {
        Some(row_sizes(self, x, b))
    }

    /// max Σ_j ‖D_i⁻¹ A_ij‖ in the maximum norm.
    fn bound(&self, inverse_diagonal: &[E]) -> Option<f64> {
        let row = |i: usize| {
            self.row(i).1.iter().map(|v| inverse_diagonal[i].times(*v).norm()).sum::<f64>()
        };
        let largest = map_ranges(self.rows(), |rows| rows.map(row).fold(0.0, f64::max));
        Some(largest.into_iter().fold(0.0, f64::max))
    }

    fn check(&self) -> Result<(), Error> {
        check_size("columns of the matrix", self.columns(), self.rows())?;
        check_finite("matrix", E::flat(self.values()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::noise::noise;
    use crate::toy::second_difference;

    /// A matrix of which only what is required is known.
    struct Hidden(Csr<f64>);

    impl Operator for Hidden {
        fn rows(&self) -> usize {
            self.0.rows()
        }
        fn apply(&self, x: &[f64], y: &mut [f64]) {
            Operator::apply(&self.0, x, y);
        }
        fn diagonal(&self) -> Vec<f64> {
            Operator::diagonal(&self.0)
        }
    }

    #[test]
    fn what_is_provided_is_what_a_matrix_does_in_one_pass() {
        let n = 4000;
        let known = second_difference(n);
        let hidden = Hidden(known.clone());
        let [x, b, direction] = [1, 2, 3].map(|seed| noise(n, seed));
        let near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-13);
        let residual = |operator: &dyn Operator| {
            let mut r = vec![0.0; n];
            operator.residual(&x, &b, &mut r);
            r
        };
        assert!(near(&residual(&known), &residual(&hidden)));
        let product_dot = |operator: &dyn Operator| {
            let mut y = vec![0.0; n];
            let dot = operator.product_dot(&x, &mut y);
            (y, dot)
        };
        let ((y, dot), (hidden_y, hidden_dot)) = (product_dot(&known), product_dot(&hidden));
        assert!(near(&y, &hidden_y) && (dot - hidden_dot).abs() < 1e-10 * dot);
        let inverse_diagonal: Vec<f64> = hidden.diagonal().iter().map(|d| 1.0 / d).collect();
        let step = |operator: &dyn Operator| {
            let (mut d, mut next) = (direction.clone(), vec![0.0; n]);
            operator.chebyshev_step(ChebyshevStep {
                inverse_diagonal: &inverse_diagonal,
                keep: 0.3,
                add: 1.7,
                b: &b,
                x: &x,
                d: &mut d,
                next: &mut next,
            });
            (d, next)
        };
        let ((d, next), (hidden_d, hidden_next)) = (step(&known), step(&hidden));
        assert!(near(&d, &hidden_d) && near(&next, &hidden_next));
        // No eigenvalue of D⁻¹A exceeds 2 here; only the matrix knows.
        assert_eq!(
            (known.bound(&inverse_diagonal), hidden.bound(&inverse_diagonal)),
            (Some(2.0), None)
        );
    }
}
