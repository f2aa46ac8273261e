//! The preconditioned conjugate gradient method (Hestenes and Stiefel 1952).

use crate::error::Error;
use crate::krylov::iteration::{Iteration, SolveOptions};
use crate::krylov::operator::Operator;
use crate::krylov::preconditioner::Preconditioner;
use crate::report::{Ended, SolveReport};
use crate::sparse::dot::{dot, norm};
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::kernels::advance;
use octruss_base::chunks::for_chunks;

/// So many restarts may not halve the residual.
const VAIN_RESTARTS: usize = 4;

/// Solves A x = b for a symmetric positive definite A.
///
/// The residual of the recurrence drifts from the true one. When it is small enough the
/// true one is computed; if that is not, the method restarts with it. Of an
/// ill-conditioned system the true one may stay larger than any tolerance, as it does with
/// a direct solver: so an iterate whose [backward error](crate::backward_error) is some
/// units of rounding has converged, too ([`Ended::Rounding`]). Restarts reach that, as
/// iterative refinement does: each goes on until its residual is rounding in every row.
/// After a few that do not halve the residual nothing more can be had.
///
/// With a preconditioner that is not symmetric, directions are made conjugate to
/// the last one explicitly (the flexible form of Notay 2000), which keeps the
/// residual before.
///
/// # Errors
/// [`Error::NotPositiveDefinite`], [`Error::NotConverged`] and
/// [`Error::Stopped`] carry history and the iterate with the smallest residual;
/// [`Error::NotFinite`], [`Error::Size`] and [`Error::Option`] come before the first
/// iteration.
pub fn conjugate_gradients<E: Entry<Real = f64>>(
    matrix: &dyn Operator<E>,
    rhs: &[E::Nodal],
    preconditioner: &mut dyn Preconditioner<E::Nodal>,
    options: &SolveOptions<'_>,
) -> Result<(Vec<E::Nodal>, SolveReport), Error> {
    let mut run = Iteration::new(matrix, rhs, preconditioner.setup_seconds(), options)?;
    // In the energy norm every iterate is nearer to the solution than zero.
    let (mut x, mut r) = run.first_iterate(false);
    if run.is_small(norm(&r)) {
        return Ok(run.finish(x, Ended::Residual));
    }
    let mut vain_restarts = 0;
    let [mut z, mut p, mut q] = std::array::from_fn(|_| vec![E::Nodal::default(); rhs.len()]);
    let mut previous_rz = f64::INFINITY; // p = z in the first iteration
    let mut last_true_norm = f64::INFINITY;
    let mut last_r = if preconditioner.is_symmetric() { Vec::new() } else { r.clone() };
    while run.may_go_on() {
        preconditioner.apply(&r, &mut z);
        let rz = dot(&r, &z);
        if !(rz > 0.0 && rz.is_finite()) {
            let what = "preconditioner";
            return Err(Error::NotPositiveDefinite { what, at: run.unfinished(x) });
        }
        let keep = if last_r.is_empty() {
            rz / previous_rz
        } else {
            let fresh = rz - dot(&last_r, &z);
            last_r.copy_from_slice(&r);
            fresh / previous_rz
        };
        follow(Nodal::flat(&z), keep, Nodal::flat_mut(&mut p));
        let pq = matrix.product_dot(&p, &mut q);
        // A step that is not finite would spoil the iterate.
        if !(pq > 0.0 && (rz / pq).is_finite()) {
            return Err(Error::NotPositiveDefinite { what: "matrix", at: run.unfinished(x) });
        }
        let directions = (Nodal::flat(&p), Nodal::flat(&q));
        let (x_flat, r_flat) = (Nodal::flat_mut(&mut x), Nodal::flat_mut(&mut r));
        let residual_norm = advance(rz / pq, directions, x_flat, r_flat).sqrt();
        run.note_step(rz * (rz / pq));
        let wish = run.record(residual_norm, || {
            let step_back = |(x, p): (&E::Nodal, &E::Nodal)| x.add_scaled(-rz / pq, *p);
            x.iter().zip(&p).map(step_back).collect()
        });
        previous_rz = rz;
        if run.is_worth_a_look((&x, &r), residual_norm) {
            matrix.residual(&x, rhs, &mut r);
            let true_norm = norm(&r);
            if run.is_small(true_norm) {
                return Ok(run.finish(x, Ended::Residual));
            }
            if run.is_at_rounding(&x, &r) {
                return Ok(run.finish(x, Ended::Rounding));
            }
            vain_restarts += usize::from(true_norm > 0.5 * last_true_norm);
            if vain_restarts > VAIN_RESTARTS {
                break;
            }
            last_true_norm = true_norm;
            previous_rz = f64::INFINITY;
            run.restart(true_norm);
        }
        if wish.is_break() {
            return Err(Error::Stopped(run.unfinished(x)));
        }
    }
    // Far from the solution as steps tell, but with the residual that was asked for.
    matrix.residual(&x, rhs, &mut r);
    if run.is_small(norm(&r)) {
        return Ok(run.finish(x, Ended::Residual));
    }
    if run.is_at_rounding(&x, &r) {
        return Ok(run.finish(x, Ended::Rounding));
    }
    Err(Error::NotConverged(run.unfinished(x)))
}

/// p ← z + keep p.
fn follow(z: &[f64], keep: f64, p: &mut [f64]) {
    for_chunks(p, |first, chunk| {
        for (p, z) in chunk.iter_mut().zip(&z[first..]) {
            *p = z + keep * *p;
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::krylov::preconditioner::Identity;
    use crate::sparse::csr::Csr;
    use crate::sparse::noise::noise;
    use crate::toy::{second_difference, tridiagonal};
    use std::ops::ControlFlow;
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    #[test]
    fn n_iterations_solve_n_equations() {
        // (−1, 2, −1) x = 1 has the solution x_i = i (n + 1 − i) / 2; the
        // symmetric right-hand side needs half of the directions.
        let (matrix, rhs) = (second_difference(20), vec![1.0; 20]);
        let (x, report) =
            conjugate_gradients(&matrix, &rhs, &mut Identity, &Default::default()).unwrap();
        for (i, x) in x.iter().enumerate() {
            assert!((x - (i + 1) as f64 * (20 - i) as f64 / 2.0).abs() < 1e-9);
        }
        assert_eq!(report.iterations, 10);
        assert_eq!(report.residual_history.len(), 11);
        assert!(report.relative_residual < 1e-8);
    }

    #[test]
    fn a_zero_right_hand_side_needs_no_iteration() {
        let (x, report) = conjugate_gradients(
            &second_difference(5),
            &[0.0; 5],
            &mut Identity,
            &Default::default(),
        )
        .unwrap();
        assert_eq!((x, report.iterations, report.relative_residual), (vec![0.0; 5], 0, 0.0));
    }

    #[test]
    fn a_start_counts_by_its_true_residual_and_a_poor_one_costs_nothing() {
        let (a, rhs) = (second_difference(50), noise(50, 3));
        let solve = |start: Option<&[f64]>, tolerance: f64| {
            let options = SolveOptions { start, tolerance, ..Default::default() };
            conjugate_gradients(&a, &rhs, &mut Identity, &options).unwrap()
        };
        let (solution, from_zero) = solve(None, 1e-12);
        assert_eq!(from_zero.residual_history[0], 1.0);

        // The residual of 0.999 x is a thousandth of the right-hand side.
        let near: Vec<f64> = solution.iter().map(|x| 0.999 * x).collect();
        let (x, report) = solve(Some(&near), 1e-2);
        assert_eq!((&x, report.iterations, report.residual_history.len()), (&near, 0, 1));
        assert!((report.residual_history[0] / 1e-3 - 1.0).abs() < 1e-6);
        // The goal stays relative to the right-hand side.
        let (_, report) = solve(Some(&near), 1e-12);
        assert!(report.relative_residual <= 1e-12 && report.residual_history[0] < 1e-2);

        for factor in [-1e-3, 2.5, -1e6, 1e300] {
            let far: Vec<f64> = solution.iter().map(|x| factor * x).collect();
            let (x, report) = solve(Some(&far), 1e-12);
            assert_eq!(
                (x, report.residual_history),
                (solution.clone(), from_zero.residual_history.clone())
            );
        }
        let zero = conjugate_gradients(
            &a,
            &[0.0; 50],
            &mut Identity,
            &SolveOptions { start: Some(&near), ..Default::default() },
        );
        assert_eq!(zero.unwrap().0, [0.0; 50]);
    }

    #[test]
    fn a_senseless_start_is_refused() {
        let (a, rhs) = (second_difference(5), [1.0; 5]);
        let solve = |start: &[f64]| {
            let options = SolveOptions { start: Some(start), ..Default::default() };
            conjugate_gradients(&a, &rhs, &mut Identity, &options).unwrap_err()
        };
        assert!(matches!(solve(&[0.0; 4]), Error::Size { found: 4, expected: 5, .. }));
        let hole = [0.0, 0.0, f64::NAN, 0.0, 0.0];
        assert!(matches!(solve(&hole), Error::NotFinite { what: "start", index: 2, .. }));
    }

    #[test]
    fn the_iterate_with_the_smallest_residual_is_kept() {
        // Weights over six decades: residuals rise and fall.
        let a = second_difference(60);
        let weights: Vec<f64> = (0..60).map(|i| 10f64.powi(i % 7)).collect();
        let row = |i: usize| a.row(i).0.iter().map(move |j| (i, *j as usize));
        let scales: Vec<f64> =
            (0..60).flat_map(row).map(|(i, j)| (weights[i] * weights[j]).sqrt()).collect();
        let scaled = a.values().iter().zip(scales).map(|(v, s)| v * s).collect();
        let (a, rhs) = (a.with_values(scaled), noise(60, 4));
        let mut risen = 0;
        for max_iterations in 1..40 {
            let options = SolveOptions { max_iterations, ..Default::default() };
            let solved = conjugate_gradients(&a, &rhs, &mut Identity, &options);
            let Err(Error::NotConverged(at)) = solved else { panic!("no convergence") };
            let history = &at.report.residual_history[1..];
            let smallest = history.iter().copied().fold(f64::INFINITY, f64::min);
            assert!((at.report.relative_residual / smallest - 1.0).abs() < 1e-6);
            risen += usize::from(history[history.len() - 1] > smallest);
        }
        assert!(risen > 5, "{risen}");
    }

    #[test]
    fn failures_are_values_with_history() {
        let solve = |matrix: &Csr<f64>, rhs: &[f64], options: &SolveOptions| {
            conjugate_gradients(matrix, rhs, &mut Identity, options).unwrap_err()
        };
        let all = SolveOptions::default();
        let a = second_difference(50);
        let mut rhs = vec![1.0; 50];

        let few = SolveOptions { max_iterations: 3, ..all };
        let Error::NotConverged(at) = solve(&a, &rhs, &few) else { panic!("no convergence") };
        assert_eq!((at.report.iterations, at.report.residual_history.len()), (3, 4));
        assert!(at.iterate.iter().all(|x| *x > 0.0));

        let indefinite = solve(&tridiagonal(50, -1.0, 1.0), &rhs, &all);
        assert!(matches!(indefinite, Error::NotPositiveDefinite { what: "matrix", .. }));

        let seen = AtomicUsize::new(0);
        let stop = |iteration: usize, _: f64| {
            seen.store(iteration, Relaxed);
            if iteration == 4 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let stopped = solve(&a, &rhs, &SolveOptions { progress: Some(&stop), ..all });
        assert!(matches!(stopped, Error::Stopped(at) if at.report.iterations == 4));
        assert_eq!(seen.into_inner(), 4);

        // Beyond what rounding allows: that is the end, long before the limit.
        let greedy = SolveOptions { tolerance: 1e-30, max_iterations: 10_000, ..all };
        let (_, report) = conjugate_gradients(&a, &noise(50, 1), &mut Identity, &greedy).unwrap();
        assert!(report.iterations < 500 && report.relative_residual < 1e-12);
        assert_eq!(report.ended, Ended::Rounding);
        assert!(report.backward_error.unwrap() < 64.0 * f64::EPSILON);

        rhs[7] = f64::INFINITY;
        assert!(matches!(solve(&a, &rhs, &all), Error::NotFinite { index: 7, .. }));
        assert!(matches!(solve(&a, &rhs[1..], &all), Error::Size { found: 49, .. }));
        let bad = SolveOptions { tolerance: f64::NAN, ..all };
        assert!(matches!(solve(&a, &[1.0; 50], &bad), Error::Option { .. }));
    }
}
