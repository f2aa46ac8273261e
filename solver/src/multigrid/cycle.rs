//! The multigrid cycle, in one precision.

use crate::multigrid::coarse::{CoarseSolver, Elimination};
use crate::multigrid::level::{Kept, Level};
use crate::multigrid::options::CycleShape;
use crate::sparse::csr::Csr;
use crate::sparse::dot::largest;
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::real::Real;
use octruss_base::chunks::for_chunks;
use octruss_base::large_array::zeroed;

/// All smoothed levels of a scaled matrix, finest first, and the direct solver
/// below them.
pub(crate) struct Cycle<E: Entry> {
    pub(crate) levels: Vec<Level<E>>,
    pub(crate) coarsest: Coarsest,
    shape: CycleShape,
    /// All matrices are this times those of the problem.
    matrix_scale: f64,
    pub(crate) rhs: Vec<E::Nodal>,
    x: Vec<E::Nodal>,
}

/// So many cycles solve on the coarsest given level for what full multigrid needs, where
/// levels below it are algebraic.
const CYCLES_ON_THE_COARSEST: usize = 10;

/// The direct solver with its right-hand side and solution in double precision.
pub(crate) struct Coarsest {
    solver: CoarseSolver,
    rhs: Vec<f64>,
    x: Vec<f64>,
}

impl<E: Entry> Cycle<E> {
    pub(crate) fn new(
        unknowns: usize,
        levels: Vec<Level<E>>,
        coarsest: Coarsest,
        shape: CycleShape,
        matrix_scale: f64,
    ) -> Self {
        let (rhs, x) = (zeroed(unknowns), zeroed(unknowns));
        Self { levels, coarsest, shape, matrix_scale, rhs, x }
    }

    /// What another matrix with the same pattern can use.
    pub(crate) fn into_kept(self) -> (Vec<Kept<E>>, Option<Elimination>) {
        let transfers = self.levels.into_iter().map(Level::into_kept).collect();
        (transfers, self.coarsest.solver.into_elimination())
    }

    /// z = one cycle for A z = r, from zero.
    pub(crate) fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        self.scaled(r, z, |cycle| {
            descend(
                cycle.shape,
                &mut cycle.levels,
                &mut cycle.coarsest,
                (&cycle.rhs, &mut cycle.x),
                true,
            );
        });
    }

    /// z = full multigrid for A z = r: the coarsest of `given` levels below the finest solved
    /// (by cycles, where others lie below it), then on each finer one its solution, brought
    /// there by a matrix of `transfers` (finest first) or by the prolongation, improved by
    /// `cycles` cycles.
    pub(crate) fn full(
        &mut self,
        r: &[f64],
        (transfers, given): (&[&Csr<f64>], usize),
        cycles: usize,
        z: &mut [f64],
    ) {
        self.scaled(r, z, |cycle| {
            let mut sides = vec![cycle.rhs.clone()];
            for level in &cycle.levels[..given] {
                sides.push(level.restrict(&sides[sides.len() - 1]));
            }
            let mut x = vec![E::Nodal::default(); sides[given].len()];
            let below = &mut cycle.levels[given..];
            let solves = if below.is_empty() { 1 } else { CYCLES_ON_THE_COARSEST };
            for first in std::iter::once(true).chain(std::iter::repeat(false)).take(solves) {
                let system = (&*sides[given], &mut x);
                descend(cycle.shape, &mut *below, &mut cycle.coarsest, system, first);
            }
            for k in (0..given).rev() {
                x = cycle.levels[k].transfer(transfers.get(k).copied(), &x);
                for _ in 0..cycles {
                    let levels = &mut cycle.levels[k..];
                    descend(cycle.shape, levels, &mut cycle.coarsest, (&sides[k], &mut x), false);
                }
            }
            cycle.x = x;
        });
    }

    /// Lets `solve` turn the right-hand side into x, both in the cycle's precision.
    /// The residual is scaled to largest entry 1, so that single precision neither
    /// over- nor underflows.
    fn scaled(&mut self, r: &[f64], z: &mut [f64], solve: impl FnOnce(&mut Self)) {
        let scale = largest(r);
        if scale == 0.0 {
            return z.fill(0.0);
        }
        for_chunks(E::Nodal::flat_mut(&mut self.rhs), |first, chunk| {
            for (rhs, r) in chunk.iter_mut().zip(&r[first..]) {
                *rhs = E::Real::from_f64(r / scale);
            }
        });
        solve(self);
        let back = scale * self.matrix_scale;
        let x = E::Nodal::flat(&self.x);
        for_chunks(z, |first, chunk| {
            for (z, x) in chunk.iter_mut().zip(&x[first..]) {
                *z = back * x.to_f64();
            }
        });
    }
}

/// One cycle for A x = b, from zero (whatever `x` holds) or from `x`.
fn descend<E: Entry>(
    shape: CycleShape,
    levels: &mut [Level<E>],
    coarsest: &mut Coarsest,
    (b, x): (&[E::Nodal], &mut Vec<E::Nodal>),
    from_zero: bool,
) {
    let Some((level, coarser)) = levels.split_first_mut() else {
        return coarsest.solve(Nodal::flat(b), Nodal::flat_mut(x));
    };
    level.smooth_before(b, x, from_zero);
    level.compute_residual(b, x);
    level.restrict_residual();
    let coarse = (&*level.coarse_rhs, &mut level.coarse_x);
    descend(shape, coarser, coarsest, (coarse.0, coarse.1), true);
    // The direct solver has nothing to add the second time.
    if shape == CycleShape::W && !coarser.is_empty() {
        descend(shape, coarser, coarsest, (coarse.0, coarse.1), false);
    }
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
