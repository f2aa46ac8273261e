//! Cycles alone, without conjugate gradients: as a solver, and to measure how
//! much a cycle reduces the error.

use crate::error::Error;
use crate::krylov::iteration::{Iteration, SolveOptions};
use crate::krylov::operator::Operator;
use crate::krylov::preconditioner::Preconditioner;
use crate::report::{Ended, SolveReport};
use crate::sparse::dot::norm;
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::noise::noise;

/// Solves A x = b by x ← x + M (b − A x), M the preconditioner.
///
/// # Errors
/// [`Error::NotConverged`] and [`Error::Stopped`] carry history and the iterate
/// with the smallest residual; [`Error::NotFinite`], [`Error::Size`] and [`Error::Option`] come
/// before the first iteration.
pub fn stationary_iteration<E: Entry<Real = f64>>(
    matrix: &dyn Operator<E>,
    rhs: &[E::Nodal],
    preconditioner: &mut dyn Preconditioner<E::Nodal>,
    options: &SolveOptions<'_>,
) -> Result<(Vec<E::Nodal>, SolveReport), Error> {
    let mut run = Iteration::new(matrix, rhs, preconditioner.setup_seconds(), options)?;
    let (mut x, mut r) = run.first_iterate(true);
    if run.is_small(norm(&r)) {
        return Ok(run.finish(x, Ended::Residual));
    }
    let mut z = x.clone();
    let mut last_norm = f64::INFINITY;
    while run.may_go_on() {
        preconditioner.apply(&r, &mut z);
        z.iter_mut().zip(&x).for_each(|(z, x)| *z = x.plus(*z));
        std::mem::swap(&mut x, &mut z);
        matrix.residual(&x, rhs, &mut r);
        let residual_norm = norm(&r);
        let wish = run.record(residual_norm, || z.clone());
        if run.is_small(residual_norm) {
            return Ok(run.finish(x, Ended::Residual));
        }
        // Looked at only where nothing was gained: it costs about a product.
        if residual_norm >= last_norm && run.is_at_rounding(&x, &r) {
            return Ok(run.finish(x, Ended::Rounding));
        }
        last_norm = residual_norm;
        // A diverging iteration ends in infinities: no need to wait for the limit.
        if !residual_norm.is_finite() {
            break;
        }
        if wish.is_break() {
            return Err(Error::Stopped(run.unfinished(x)));
        }
    }
    Err(Error::NotConverged(run.unfinished(x)))
}

/// How much one cycle reduces the error: the mean (geometric, over the last 8
/// of `cycles`) factor of its energy norm √(e · A e), for A e = 0 from noise.
///
/// # Errors
/// [`Error::Size`] if the matrix is not square, [`Error::NotFinite`].
pub fn mean_reduction<E: Entry<Real = f64>>(
    matrix: &dyn Operator<E>,
    preconditioner: &mut dyn Preconditioner<E::Nodal>,
    cycles: usize,
) -> Result<f64, Error> {
    const MEASURED: usize = 8;
    let factors = reductions(matrix, preconditioner, cycles)?;
    Ok(geometric_mean(&factors[cycles.saturating_sub(MEASURED)..]))
}

/// The factor by which each of some cycles reduces the energy norm √(e · A e) of the
/// error, for A e = 0 from noise.
///
/// # Errors
/// [`Error::Size`] if the matrix is not square, [`Error::NotFinite`].
pub fn reductions<E: Entry<Real = f64>>(
    matrix: &dyn Operator<E>,
    preconditioner: &mut dyn Preconditioner<E::Nodal>,
    cycles: usize,
) -> Result<Vec<f64>, Error> {
    matrix.check()?;
    let [mut error, mut image, mut correction] =
        std::array::from_fn(|_| vec![E::Nodal::default(); matrix.rows()]);
    let start = noise(matrix.rows() * E::Nodal::SIZE, 3);
    E::Nodal::flat_mut(&mut error).copy_from_slice(&start);
    let energy =
        |error: &[E::Nodal], image: &mut [E::Nodal]| matrix.product_dot(error, image).sqrt();
    let mut factors = Vec::with_capacity(cycles);
    let mut before = energy(&error, &mut image);
    for _ in 0..cycles {
        preconditioner.apply(&image, &mut correction);
        // Scaled to energy 1, so that no number of cycles underflows.
        error.iter_mut().zip(&correction).for_each(|(e, c)| *e = e.minus(*c).scaled(1.0 / before));
        before = energy(&error, &mut image);
        factors.push(before);
        // Nothing is left: a direct solver does that.
        if before == 0.0 {
            factors.resize(cycles, 0.0);
            break;
        }
    }
    Ok(factors)
}

/// 1 for no factors.
pub fn geometric_mean(factors: &[f64]) -> f64 {
    let logarithms: f64 = factors.iter().map(|factor| factor.ln()).sum();
    (logarithms / factors.len().max(1) as f64).exp()
}
