//! The unknowns of one level, whatever the problem.

use crate::boundary::constraints::Constraints;
use crate::boundary::dofs::Dofs;
use octruss_solver::{Entry, Nodal, project};

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
        let prescribed = constraints.prescribed();
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
    pub(crate) fn unknowns(&self, all: &[f64]) -> Vec<E::Nodal> {
        let size = E::Nodal::SIZE;
        let at = |&vertex: &u32| E::Nodal::from_fn(|k| all[size * vertex as usize + k]);
        let mut x: Vec<E::Nodal> = self.dofs.free().iter().map(at).collect();
        project(&self.projectors, &mut x);
        x
    }
}
