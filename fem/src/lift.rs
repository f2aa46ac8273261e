//! Smooth extensions of prescribed values into the body.
//!
//! Coarse levels cannot see how a solution bends in the outermost layer of elements,
//! where prescribed values other than zero stand only at vertices without unknown.
//! So full multigrid solves for the rest that a smooth extension leaves. This one is
//! the coarsest level's solution, carried from level to level with all its vertices,
//! where each level puts its own prescribed values in their place: what that changes
//! bends it, at the size of that level's elements, no more than the solution.

use crate::boundary::level_unknowns::LevelUnknowns;
use crate::error::Error;
use octruss_mesh::SubdivisionMatrix;
use octruss_solver::check_size;
use octruss_solver::{Entry, Nodal};
use std::borrow::Borrow;

/// Extends the prescribed values of the finest level smoothly into the body: the
/// unknowns of a function that takes them.
///
/// `coarsest` are the unknowns of the first of `levels`, best the solution of the
/// same problem assembled there; `transfers`, one fewer than levels, carry values at
/// all vertices. Both lists have the **coarsest first**.
///
/// With the lift g, [`Multigrid::full_multigrid`](octruss_solver::Multigrid::full_multigrid)
/// of the right-hand side b − A g gives what is to be added to g.
///
/// # Errors
/// [`octruss_solver::Error::Size`] if the levels, the transfers and `coarsest` do not fit together.
pub fn smooth_lift<E: Entry<Real = f64>>(
    coarsest: &[E::Nodal],
    transfers: &[impl Borrow<SubdivisionMatrix>],
    levels: &[LevelUnknowns<E>],
) -> Result<Vec<E::Nodal>, Error> {
    check_size("levels of a lift", levels.len(), transfers.len() + 1)?;
    check_size("unknowns of the coarsest level", coarsest.len(), levels[0].dofs.unknowns())?;
    let mut x = coarsest.to_vec();
    for (transfer, (coarse, fine)) in transfers.iter().zip(levels.iter().zip(&levels[1..])) {
        let transfer = transfer.borrow();
        check_size("rows of a transfer", transfer.rows(), fine.dofs.vertices())?;
        check_size("columns of a transfer", transfer.columns(), coarse.dofs.vertices())?;
        let values = coarse.expand(&x);
        x = fine.unknowns(&transfer.apply_field(Nodal::flat(&values), E::Nodal::SIZE));
    }
    Ok(x)
}
