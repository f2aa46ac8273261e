//! All levels of a multigrid, whichever the precision of its cycle: how they are built
//! and what is done with them.

use crate::error::{Error, check_finite};
use crate::multigrid::aggregation::candidates::Candidates;
use crate::multigrid::aggregation::near_null_space::NearNullSpace;
use crate::multigrid::cycle::Cycle;
use crate::multigrid::descent::Descent;
use crate::multigrid::figures::summary::{LevelOrigin, LevelSummary};
use crate::multigrid::figures::traffic::{Traffic, cycle_bytes, measure};
use crate::multigrid::input::{AnyTransfer, GivenLevels, SetupInput};
use crate::multigrid::options::{Precision, ResolvedOptions};
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoother::level_smoother::Grouping;
use crate::multigrid::transfer::Transfer;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Entry;
use crate::sparse::pattern::Pattern;
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
    /// What the levels below the given ones are made from.
    below: NearNullSpace,
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
    /// All levels from the finest matrix, transfers, the projectors of each level, and the
    /// near-null space of the last.
    ///
    /// # Errors
    /// As [`Multigrid::with_transfers`](crate::Multigrid::with_transfers).
    pub(crate) fn new(
        matrix: &Csr<E>,
        transfers: Vec<Transfer<E>>,
        projectors: Vec<Vec<(u32, E)>>,
        below: NearNullSpace,
        options: &ResolvedOptions,
    ) -> Result<Self, Error> {
        let given = GivenLevels { transfers, projectors, below };
        match options.precision {
            Precision::Single => {
                let input = SetupInput::new(matrix, given, options.smoother)?;
                Self::build(matrix, input, options, AnyCycle::Single)
            }
            Precision::Double => {
                let input = SetupInput::new(matrix, given, options.smoother)?;
                Self::build(matrix, input, options, AnyCycle::Double)
            }
        }
    }

    /// The same for a matrix with other numbers in the same places.
    ///
    /// # Errors
    /// As [`Multigrid::updated`](crate::Multigrid::updated).
    pub(crate) fn updated(self, matrix: &Csr<E>, options: &ResolvedOptions) -> Result<Self, Error> {
        let is_given = |level: &LevelSummary| level.origin == LevelOrigin::Given;
        let keeps_order = self.summaries.iter().all(is_given);
        let Self { cycle, projectors, patterns, below, keeps_galerkin, .. } = self;
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
                let input = SetupInput::of(cycle, keeps_order, (projectors, patterns, below));
                Self::build(matrix, input, options, AnyCycle::Single)
            }
            AnyCycle::Double(cycle) => {
                let input = SetupInput::of(cycle, keeps_order, (projectors, patterns, below));
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
        let SetupInput { transfers, projectors, mut patterns, elimination, domains, below } = input;
        let keeps_galerkin = transfers.iter().all(AnyTransfer::is_galerkin);
        let mut descent = Descent::<E, F>::new(matrix, transfers.len(), options)?;
        let mut groupings = domains.into_iter().map(Grouping::Domains);
        for ((number, transfer), pair) in
            transfers.into_iter().enumerate().zip(projectors.windows(2))
        {
            let both = [&pair[0], &pair[1]];
            let (current, diagonal) = (&*descent.current, &mut descent.diagonal);
            let (mut kept, coarser) = match transfer {
                AnyTransfer::New(transfer) => transfer.apply((current, diagonal), both),
                AnyTransfer::Kept(kept) => {
                    let pattern = patterns.get(number + 1);
                    let product = kept.galerkin((current, both[0]), both[1], pattern);
                    (kept, product.expect("only Galerkin products of numbers are kept"))
                }
            };
            if patterns.len() == number + 1 {
                patterns.push(Arc::clone(coarser.pattern()));
            }
            kept.grouping = kept.grouping.or_else(|| groupings.next());
            let coarser = descent.with_diagonal(coarser)?;
            descent.step(kept, coarser, both, LevelOrigin::Given);
        }
        if below == NearNullSpace::Unknown {
            descent.afford_any_factor();
        }
        let coarsest = &projectors[projectors.len() - 1];
        let candidates = Candidates::new(&below, descent.current.rows(), coarsest)?;
        let elimination = match elimination {
            None => descent.below_the_given(candidates, coarsest)?,
            known => known,
        };
        let (cycle, summaries) = descent.finish(elimination)?;
        Ok(Self { cycle: any(cycle), projectors, patterns, summaries, below, keeps_galerkin })
    }

    /// How many transfers were given; levels below are algebraic.
    pub(crate) fn given(&self) -> usize {
        self.patterns.len() - 1
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
        let given = self.given();
        with_cycle!(&mut self.cycle, cycle => cycle.full(r, (transfers, given), cycles, z));
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
