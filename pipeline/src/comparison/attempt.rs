//! A solve that may fail to converge: a finding here, not an error.

use octruss_fem::{Discretisation, Error, Options, Unknown};
use octruss_solver::{
    Entry, Error as SolverError, Multigrid, SolveOptions, SolveReport, conjugate_gradients,
};

use crate::stages::Context;

/// The unknowns, and what it took to find them.
pub(super) type Solved<E> = (Vec<<E as Entry>::Nodal>, SolveReport);

/// The unknowns and the report of a solve by conjugate gradients to the tolerance of the
/// stage; none if that was not reached.
///
/// # Errors
/// Whatever else the solver reports, also that it was asked to stop.
pub(super) fn attempt<E: Unknown>(
    options: &Options,
    (discrete, rhs): (&Discretisation<E>, &[E::Nodal]),
    multigrid: &mut Multigrid<E>,
    context: &Context,
) -> Result<Option<Solved<E>>, Error> {
    let tell = |_: usize, _: f64| context.go_on();
    let goal = SolveOptions {
        tolerance: options.tolerance,
        max_iterations: options.max_iterations,
        progress: Some(&tell),
        ..SolveOptions::default()
    };
    match conjugate_gradients(&discrete.matrix, rhs, multigrid, &goal) {
        Ok(solved) => Ok(Some(solved)),
        Err(SolverError::NotConverged(_) | SolverError::NotPositiveDefinite { .. }) => Ok(None),
        Err(error) => Err(error.into()),
    }
}
