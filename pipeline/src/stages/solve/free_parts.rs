//! What is told of parts that nothing holds.

use octruss_fem::{Discretisation, Unknown};

use crate::report::FreePartFigures;

/// What was added to loads less than this, relative to them, is rounding or quadrature.
const NEGLIGIBLE: f64 = 1e-6;

/// The parts that nothing holds, and notes on those whose loads do not balance.
pub(super) fn free_parts<E: Unknown>(
    discrete: &Discretisation<E>,
) -> (Vec<FreePartFigures>, Vec<String>) {
    let balances = discrete.free.iter().flat_map(|free| &free.balances);
    let parts: Vec<FreePartFigures> = balances.map(FreePartFigures::from).collect();
    // Written so that NaN is told.
    let is_balanced = |part: &&FreePartFigures| part.share <= NEGLIGIBLE;
    let notes = parts.iter().filter(|part| !is_balanced(part)).map(FreePartFigures::note);
    let notes = notes.collect();
    (parts, notes)
}
