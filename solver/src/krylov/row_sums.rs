//! A matrix whose row sums are known better than its entries tell.

use crate::error::{Error, check_size};
use crate::krylov::operator::Operator;
use crate::sparse::csr::Csr;
use crate::sparse::dot::chunk_dot;
use crate::sparse::entry::{Entry, Nodal};
use octruss_base::chunks::{for_chunks, map_chunks};

/// A matrix together with its row sums s_i, so that (A x)_i = s_i x_i + Σ_j a_ij (x_j − x_i).
///
/// A Laplacian sends constants to zero, but its diagonal is rounded: as a matrix it holds
/// a sink of ε a_ii in each row. Where a stiff layer hands a flux on that soft ones let through,
/// c times less than its entries, these sinks swallow a share ε c of it, and a direct
/// solution of the rounded matrix is as wrong. With the sums that assembly knows, and
/// differences, which are exact for what hardly varies, products are as accurate as if the
/// diagonal had no rounding.
#[derive(Clone, Copy)]
pub struct WithRowSums<'m, E: Entry = f64> {
    matrix: &'m Csr<E>,
    sums: &'m [E],
}

impl<'m, E: Entry> WithRowSums<'m, E> {
    /// `sums` has the sum of each row of the square `matrix`.
    ///
    /// # Errors
    /// [`Error::Size`] unless there is one for each row.
    pub fn new(matrix: &'m Csr<E>, sums: &'m [E]) -> Result<Self, Error> {
        check_size("row sums", sums.len(), matrix.rows())?;
        Ok(Self { matrix, sums })
    }

    /// The rows of A x from row `first` on: entry and place.
    #[inline(always)]
    fn for_rows(
        &self,
        x: &[E::Nodal],
        first: usize,
        n: usize,
        mut put: impl FnMut(usize, E::Nodal),
    ) {
        let rows = self.matrix.rows_in(first..first + n);
        for (k, ((columns, values), sum)) in rows.zip(&self.sums[first..]).enumerate() {
            let here = x[first + k];
            // On the diagonal the difference is 0.
            let terms = columns.iter().zip(values);
            let differences = terms.fold(E::Nodal::default(), |total, (&j, value)| {
                value.add_product(x[j as usize].minus(here), total)
            });
            put(k, sum.add_product(here, differences));
        }
    }
}

impl<E: Entry> Operator<E> for WithRowSums<'_, E> {
    fn rows(&self) -> usize {
        self.matrix.rows()
    }

    fn apply(&self, x: &[E::Nodal], y: &mut [E::Nodal]) {
        for_chunks(y, |first, y| self.for_rows(x, first, y.len(), |k, product| y[k] = product));
    }

    fn diagonal(&self) -> Vec<E> {
        Operator::diagonal(self.matrix)
    }

    fn residual(&self, x: &[E::Nodal], b: &[E::Nodal], r: &mut [E::Nodal]) {
        for_chunks(r, |first, r| {
            self.for_rows(x, first, r.len(), |k, product| r[k] = b[first + k].minus(product));
        });
    }

    fn product_dot(&self, x: &[E::Nodal], y: &mut [E::Nodal]) -> f64 {
        let sums = map_chunks(y, |first, y| {
            self.for_rows(x, first, y.len(), |k, product| y[k] = product);
            chunk_dot(Nodal::flat(y), Nodal::flat(&x[first..first + y.len()]))
        });
        sums.iter().sum()
    }

    /// Those of the matrix: however a product is summed up, x itself is rounded, so that a
    /// stiff layer's flux may be less than what its values can tell.
    fn row_sizes(&self, x: &[E::Nodal], b: &[E::Nodal]) -> Option<Vec<E::Nodal>> {
        self.matrix.row_sizes(x, b)
    }

    fn bound(&self, inverse_diagonal: &[E]) -> Option<f64> {
        self.matrix.bound(inverse_diagonal)
    }

    fn check(&self) -> Result<(), Error> {
        self.matrix.check()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::krylov::cg::conjugate_gradients;
    use crate::krylov::iteration::SolveOptions;
    use crate::multigrid::options::MultigridOptions;
    use crate::multigrid::setup::Multigrid;
    use crate::sparse::noise::noise;

    /// A chain of links with these stiffnesses from a fixed end to a free one.
    fn chain(stiffness: &[f64]) -> (Csr<f64>, Vec<f64>) {
        let n = stiffness.len();
        let next = |i: usize| stiffness.get(i + 1).copied().unwrap_or(0.0);
        let (mut offsets, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
        for i in 0..n {
            let mut push = |j: usize, value: f64| {
                indices.push(j as u32);
                values.push(value);
            };
            if i > 0 {
                push(i - 1, -stiffness[i]);
            }
            push(i, stiffness[i] + next(i));
            if i + 1 < n {
                push(i + 1, -next(i));
            }
            offsets.push(indices.len());
        }
        let mut sums = vec![0.0; n];
        sums[0] = stiffness[0];
        (Csr::new(n, offsets, indices, values).unwrap(), sums)
    }

    #[test]
    fn products_are_those_of_the_matrix() {
        let (a, sums) = chain(&[1.0, 0.5, 3.0, 2.0, 0.25].repeat(1000));
        let (x, b) = (noise(5000, 1), noise(5000, 2));
        let known = WithRowSums::new(&a, &sums).unwrap();
        let near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-13);
        let of = |operator: &dyn Operator| {
            let [mut r, mut y, mut z] = [(); 3].map(|()| vec![0.0; 5000]);
            operator.residual(&x, &b, &mut r);
            operator.apply(&x, &mut z);
            let dot = operator.product_dot(&x, &mut y);
            assert_eq!(y, z);
            (r, y, dot)
        };
        let ((r, y, dot), (plain_r, plain_y, plain_dot)) = (of(&known), of(&a));
        assert!(near(&r, &plain_r) && near(&y, &plain_y) && (dot - plain_dot).abs() < 1e-10);
        assert!(WithRowSums::new(&a, &sums[1..]).is_err());
    }

    #[test]
    fn stiff_links_between_soft_ones_lose_nothing_of_a_pull() {
        // A pull of 1 at the end stretches each link by 1 / stiffness. The stiffness of
        // the stiff ones is no power of two: sums of two of them are rounded.
        let stiffness: Vec<f64> =
            (0..3000).map(|i| if i % 1000 < 500 { 1.0 } else { 1e9 / (3.0 + i as f64) }).collect();
        let (a, sums) = chain(&stiffness);
        let mut pull = vec![0.0; 3000];
        pull[2999] = 1.0;
        let expected: f64 = stiffness.iter().map(|stiffness| 1.0 / stiffness).sum();
        let error = |operator: &dyn Operator| {
            let mut cycle = Multigrid::new(&a, Vec::new(), &MultigridOptions::default()).unwrap();
            let options = SolveOptions { tolerance: 1e-10, ..Default::default() };
            let (x, _) = conjugate_gradients(operator, &pull, &mut cycle, &options).unwrap();
            (x[2999] / expected - 1.0).abs()
        };
        let known = error(&WithRowSums::new(&a, &sums).unwrap());
        assert!(known < 1e-9, "{known:e}");
        assert!(error(&a) > 1e-7);
    }
}
