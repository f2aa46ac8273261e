//! The V-cycle, in one precision.

use crate::chunks::for_chunks;
use crate::coarse::CoarseSolver;
use crate::dot::largest;
use crate::entry::{Entry, Nodal};
use crate::level::Level;
use crate::real::Real;

/// All smoothed levels of a scaled matrix, finest first, and the direct solver
/// below them.
pub(crate) struct VCycle<E: Entry> {
    pub(crate) levels: Vec<Level<E>>,
    pub(crate) coarsest: Coarsest,
    /// All matrices are this times those of the problem.
    matrix_scale: f64,
    rhs: Vec<E::Nodal>,
    x: Vec<E::Nodal>,
}

/// The direct solver with its right-hand side and solution in double precision.
pub(crate) struct Coarsest {
    solver: CoarseSolver,
    rhs: Vec<f64>,
    x: Vec<f64>,
}

impl<E: Entry> VCycle<E> {
    pub(crate) fn new(
        unknowns: usize,
        levels: Vec<Level<E>>,
        coarsest: Coarsest,
        matrix_scale: f64,
    ) -> Self {
        let zero = vec![E::Nodal::default(); unknowns];
        Self { levels, coarsest, matrix_scale, rhs: zero.clone(), x: zero }
    }

    /// z = one cycle for A z = r, from zero. The residual is scaled to largest
    /// entry 1, so that single precision neither over- nor underflows.
    pub(crate) fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let scale = largest(r);
        if scale == 0.0 {
            return z.fill(0.0);
        }
        for_chunks(E::Nodal::flat_mut(&mut self.rhs), |first, chunk| {
            for (rhs, r) in chunk.iter_mut().zip(&r[first..]) {
                *rhs = E::Real::from_f64(r / scale);
            }
        });
        v_cycle(&mut self.levels, &mut self.coarsest, &self.rhs, &mut self.x);
        let back = scale * self.matrix_scale;
        let x = E::Nodal::flat(&self.x);
        for_chunks(z, |first, chunk| {
            for (z, x) in chunk.iter_mut().zip(&x[first..]) {
                *z = back * x.to_f64();
            }
        });
    }
}

fn v_cycle<E: Entry>(
    levels: &mut [Level<E>],
    coarsest: &mut Coarsest,
    b: &[E::Nodal],
    x: &mut Vec<E::Nodal>,
) {
    let Some((level, coarser)) = levels.split_first_mut() else {
        return coarsest.solve(Nodal::flat(b), Nodal::flat_mut(x));
    };
    level.smooth_before(b, x);
    level.restrict_residual(b, x);
    v_cycle(coarser, coarsest, &level.coarse_rhs, &mut level.coarse_x);
    level.correct(x);
    level.smooth_after(b, x);
}

impl Coarsest {
    pub(crate) fn new(solver: CoarseSolver, unknowns: usize) -> Self {
        Self { solver, rhs: vec![0.0; unknowns], x: vec![0.0; unknowns] }
    }

    fn solve<T: Real>(&mut self, b: &[T], x: &mut [T]) {
        self.rhs.iter_mut().zip(b).for_each(|(rhs, b)| *rhs = b.to_f64());
        self.solver.solve(&self.rhs, &mut self.x);
        x.iter_mut().zip(&self.x).for_each(|(out, x)| *out = T::from_f64(*x));
    }
}
