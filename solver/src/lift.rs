//! Smooth extensions of prescribed values into the body.
//!
//! Coarse levels cannot see how a solution bends in the outermost layer of elements,
//! where prescribed values other than zero stand only at vertices without unknown.
//! So full multigrid solves for the rest that a smooth extension leaves. This one is
//! the coarsest level's solution, carried from level to level with all its vertices,
//! where each level puts its own prescribed values in their place: what that changes
//! bends it, at the size of that level's elements, no more than the solution.

use crate::constraints::Constraints;
use crate::dofs::Dofs;
use crate::entry::{Entry, Nodal};
use crate::error::{Error, check_size};
use crate::projectors::project;
use octruss_mesh::SubdivisionMatrix;
use std::borrow::Borrow;

/// What is unknown on one level, and what is prescribed.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelUnknowns<E: Entry> {
    /// Which vertices carry unknowns.
    pub dofs: Dofs,
    /// Those that are held in some directions, with the projector onto the free
    /// ones: (unknown, projector), ascending.
    pub projectors: Vec<(u32, E)>,
    /// What is prescribed at each vertex; 0 where, or in directions in which, it is
    /// free.
    pub prescribed: Vec<E::Nodal>,
}

impl From<Dofs> for LevelUnknowns<f64> {
    fn from(dofs: Dofs) -> Self {
        let prescribed = (0..dofs.vertices() as u32).map(|vertex| dofs.value(vertex)).collect();
        Self { dofs, projectors: Vec::new(), prescribed }
    }
}

impl From<&Constraints> for LevelUnknowns<[[f64; 3]; 3]> {
    fn from(constraints: &Constraints) -> Self {
        let mut prescribed = vec![[0.0; 3]; constraints.dofs().vertices()];
        for held in constraints.held() {
            prescribed[held.vertex as usize] = held.value;
        }
        let (dofs, projectors) = (constraints.dofs().clone(), constraints.projectors());
        Self { dofs, projectors, prescribed }
    }
}

impl<E: Entry<Real = f64>> LevelUnknowns<E> {
    /// Whether all prescribed values are 0.
    pub fn is_homogeneous(&self) -> bool {
        Nodal::flat(&self.prescribed).iter().all(|value| *value == 0.0)
    }

    /// A value for each vertex from unknowns `x` that respect the projectors.
    pub fn expand(&self, x: &[E::Nodal]) -> Vec<E::Nodal> {
        let mut all = self.prescribed.clone();
        for (&vertex, x) in self.dofs.free().iter().zip(x) {
            all[vertex as usize] = all[vertex as usize].plus(*x);
        }
        all
    }

    /// The unknowns from the numbers of all vertices.
    fn unknowns(&self, all: &[f64]) -> Vec<E::Nodal> {
        let size = E::Nodal::SIZE;
        let at = |&vertex: &u32| E::Nodal::from_fn(|k| all[size * vertex as usize + k]);
        let mut x: Vec<E::Nodal> = self.dofs.free().iter().map(at).collect();
        project(&self.projectors, &mut x);
        x
    }
}

/// Extends the prescribed values of the finest level smoothly into the body: the
/// unknowns of a function that takes them.
///
/// `coarsest` are the unknowns of the first of `levels`, best the solution of the
/// same problem assembled there; `transfers`, one fewer than levels, carry values at
/// all vertices. Both lists have the **coarsest first**.
///
/// With the lift g, [`Multigrid::full_multigrid`](crate::Multigrid::full_multigrid)
/// of the right-hand side b − A g gives what is to be added to g.
///
/// # Errors
/// [`Error::Size`] if the levels, the transfers and `coarsest` do not fit together.
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
