//! A problem for what its solution differs by from a constant or a rigid motion.

use octruss_solver::Nodal;

/// The right-hand side of a problem whose solution is measured from a reference r, for each
/// part of the body a constant or a rigid motion, on which the equation acts as on zero.
///
/// Values prescribed far from zero (a temperature of 300 K that varies by 1e-3, a
/// displacement of 1e3 with strains of 1e-6) leave few digits to differences, and a
/// tolerance relative to them says nothing about these. So A d = `rhs` is solved for the
/// difference d, of which all digits are left to gradients, and the solution is r + d.
/// The matrix is that of the problem itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference<V> {
    /// r at each vertex; 0 on parts where nothing is prescribed far from zero.
    pub reference: Vec<V>,
    /// What is prescribed at each vertex, less r; 0 where, or in directions in which, it
    /// is free.
    pub prescribed: Vec<V>,
    /// One entry for each free unknown.
    pub rhs: Vec<V>,
}

impl<V: Nodal<Real = f64>> Difference<V> {
    /// The difference at each vertex from that at the unknowns, which belong to the
    /// vertices `free` and respect the constraints.
    pub(crate) fn expand(&self, free: &[u32], x: &[V]) -> Vec<V> {
        let mut all = self.prescribed.clone();
        for (&vertex, x) in free.iter().zip(x) {
            all[vertex as usize] = all[vertex as usize].plus(*x);
        }
        all
    }

    /// The reference at the unknowns, which belong to the vertices `free`.
    pub(crate) fn at_unknowns(&self, free: &[u32]) -> Vec<V> {
        free.iter().map(|&vertex| self.reference[vertex as usize]).collect()
    }
}
