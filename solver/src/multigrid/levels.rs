//! All levels of a multigrid, whichever the precision of its cycle: how they are built
//! and what is done with them.

use crate::error::{Error, check_finite};
use crate::multigrid::coarse::CoarseSolver;
use crate::multigrid::cycle::{Coarsest, Cycle};
use crate::multigrid::figures::summary::LevelSummary;
use crate::multigrid::figures::traffic::{Traffic, cycle_bytes, measure};
use crate::multigrid::input::{AnyTransfer, SetupInput};
use crate::multigrid::level::Level;
use crate::multigrid::options::{Precision, ResolvedOptions};
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::multigrid::smoother::level_smoother::Grouping;
use crate::multigrid::transfer::Transfer;
use crate::sparse::blocks::expand_blocks;
use crate::sparse::csr::Csr;
use crate::sparse::dot::largest;
use crate::sparse::entry::Entry;
use crate::sparse::pattern::Pattern;
use std::borrow::Cow;
use std::sync::Arc;

/// The levels, in here **finest first**, as they are built and visited; what is told to the
/// outside (errors, traffic) counts from the coarsest.
pub struct Levels<E: Entry> {
    cycle: AnyCycle<E>,
    /// Which directions of each level's rows are free.
    projectors: Vec<Projectors<E>>,
    /// Where each level's matrix has entries.
    patterns: Vec<Arc<Pattern>>,
    pub(crate) summaries: Vec<LevelSummary>,
    /// Whether all coarse matrices are Galerkin products of plain prolongations.
    keeps_galerkin: bool,
}

enum AnyCycle<E: Entry> {
    Single(Cycle<E::Single>),
    Double(Cycle<E>),
}

/// Does the same with the cycle of either precision.
macro_rules! with_cycle {
    ($any:expr, $cycle:ident => $work:expr) => {
        match $any {
            AnyCycle::Single($cycle) => $work,
            AnyCycle::Double($cycle) => $work,
        }
    };
}

impl<E: Entry<Real = f64>> Levels<E> {
    /// All levels from the finest matrix, transfers and the projectors of each level.
    ///
    /// # Errors
    /// As [`Multigrid::with_transfers`](crate::Multigrid::with_transfers).
    pub(crate) fn new(
        matrix: &Csr<E>,
        transfers: Vec<Transfer<E>>,
        projectors: Vec<Vec<(u32, E)>>,
        options: &ResolvedOptions,
    ) -> Result<Self, Error> {
        match options.precision {
            Precision::Single => {
                let input = SetupInput::new(matrix, transfers, projectors, options.smoother)?;
                Self::build(matrix, input, options, AnyCycle::Single)
            }
            Precision::Double => {
                let input = SetupInput::new(matrix, transfers, projectors, options.smoother)?;
                Self::build(matrix, input, options, AnyCycle::Double)
            }
        }
    }

    /// The same for a matrix with other numbers in the same places.
    ///
    /// # Errors
    /// As [`Multigrid::updated`](crate::Multigrid::updated).
    pub(crate) fn updated(self, matrix: &Csr<E>, options: &ResolvedOptions) -> Result<Self, Error> {
        let Self { cycle, projectors, patterns, keeps_galerkin, .. } = self;
        let is_shared = Arc::ptr_eq(matrix.pattern(), &patterns[0]);
        if !is_shared && **matrix.pattern() != *patterns[0] {
            return Err(Error::Pattern);
        }
        check_finite("matrix", E::flat(matrix.values()))?;
        if !keeps_galerkin {
            let (option, expected) = ("transfers", "Galerkin products of plain prolongations");
            return Err(Error::Option { option, expected });
        }
        match cycle {
            AnyCycle::Single(cycle) => {
                let input = SetupInput::of(cycle, projectors, patterns);
                Self::build(matrix, input, options, AnyCycle::Single)
            }
            AnyCycle::Double(cycle) => {
                let input = SetupInput::of(cycle, projectors, patterns);
                Self::build(matrix, input, options, AnyCycle::Double)
            }
        }
    }

    /// Levels from the finest to the coarsest, with entries `F` in the cycle.
    fn build<F: Entry>(
        matrix: &Csr<E>,
        input: SetupInput<E, F>,
        options: &ResolvedOptions,
        any: fn(Cycle<F>) -> AnyCycle<E>,
    ) -> Result<Self, Error> {
        let SetupInput { transfers, projectors, mut patterns, elimination, domains } = input;
        // Levels are called by their number from the coarsest.
        let above = transfers.len();
        let mut diagonal = Diagonal::new(matrix, above)?;
        let scale = scale_to_one(E::flat(&diagonal.entries));
        let (mut levels, mut summaries) = (Vec::new(), Vec::new());
        let mut current = Cow::Borrowed(matrix);
        let keeps_galerkin = transfers.iter().all(AnyTransfer::is_galerkin);
        let mut groupings = domains.into_iter().map(Grouping::Domains);
        for (transfer, constrained) in transfers.into_iter().zip(projectors.windows(2)) {
            let (number, both) = (levels.len(), [&constrained[0], &constrained[1]]);
            let (mut kept, coarser) = match transfer {
                AnyTransfer::New(transfer) => transfer.apply((&current, &diagonal), both),
                AnyTransfer::Kept(kept) => {
                    let pattern = patterns.get(number + 1);
                    let product = kept.galerkin((&current, both[0]), both[1], pattern);
                    (kept, product.expect("only Galerkin products of numbers are kept"))
                }
            };
            if patterns.len() == number + 1 {
                patterns.push(Arc::clone(coarser.pattern()));
            }
            kept.grouping = kept.grouping.or_else(|| groupings.next());
            let scaled = (&*current, diagonal, scale);
            let level = Level::<F>::new(scaled, kept, both, options);
            summaries.push(LevelSummary {
                bytes: level.bytes(),
                prolongation_nonzeros: Some(level.prolongation.multiplications()),
                largest_eigenvalue: level.smoothing.largest_eigenvalue(),
                ..LevelSummary::of(&*current)
            });
            levels.push(level);
            current = Cow::Owned(coarser);
            diagonal = Diagonal::new(&*current, above - levels.len())?;
        }
        let solver = CoarseSolver::new(expand_blocks(&current, scale), elimination)?;
        summaries.push(LevelSummary { bytes: solver.bytes(), ..LevelSummary::of(&*current) });
        let coarsest = Coarsest::new(solver, current.rows() * E::SIZE);
        let cycle = any(Cycle::new(matrix.rows(), levels, coarsest, options.shape, scale));
        Ok(Self { cycle, projectors, patterns, summaries, keeps_galerkin })
    }

    /// z = one cycle for A z = r.
    pub(crate) fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        with_cycle!(&mut self.cycle, cycle => cycle.apply(r, z));
    }

    /// z = full multigrid for A z = r, with transfers finest first.
    pub(crate) fn full(
        &mut self,
        r: &[f64],
        transfers: &[&Csr<f64>],
        cycles: usize,
        z: &mut [f64],
    ) {
        with_cycle!(&mut self.cycle, cycle => cycle.full(r, transfers, cycles, z));
    }

    /// Bytes and seconds of each kernel.
    pub(crate) fn traffic(&mut self, repeats: usize) -> Traffic {
        let unknowns = self.summaries[0].unknowns;
        with_cycle!(&mut self.cycle, cycle => measure(cycle, unknowns, repeats))
    }

    /// The bytes that a cycle moves.
    pub(crate) fn cycle_bytes(&self, options: &ResolvedOptions) -> usize {
        let unknowns = self.summaries[0].unknowns;
        let visits = |below| options.visits(below);
        with_cycle!(&self.cycle, cycle => cycle_bytes(&cycle.levels, unknowns, visits))
    }
}

/// The power of two, so that nothing is rounded, that makes the largest entry of
/// a diagonal about 1: in other units than these a matrix may hold nothing but
/// infinities or zeros in single precision.
fn scale_to_one(diagonal: &[f64]) -> f64 {
    match largest(diagonal) {
        0.0 => 1.0,
        top => 2.0_f64.powi(-(top.log2().floor() as i32)),
    }
}
