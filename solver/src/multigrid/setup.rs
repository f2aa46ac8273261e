//! Multigrid from a matrix, and from prolongations as far as they are given.

use crate::error::{Error, check_finite, check_size};
use crate::krylov::operator::Operator;
use crate::krylov::preconditioner::Preconditioner;
use crate::multigrid::aggregation::near_null_space::NearNullSpace;
use crate::multigrid::figures::summary::LevelSummary;
use crate::multigrid::figures::traffic::Traffic;
use crate::multigrid::levels::Levels;
use crate::multigrid::options::{MultigridOptions, ResolvedOptions};
use crate::multigrid::system_entry::SystemEntry;
use crate::multigrid::transfer::Transfer;
use crate::sparse::csr::Csr;
use crate::sparse::entry::Nodal;
use std::time::Instant;

/// Levels from a matrix and prolongations, and a cycle over them.
///
/// Coarse matrices are Galerkin products Pᵀ A P unless given. Below the prolongations the
/// hierarchy goes on algebraically, by smoothed aggregation (Vaněk, Mandel and Brezina
/// 1996), until a direct solution is cheap; without any prolongation all levels are
/// algebraic. Prints itself as a table of its levels. Lists have the **coarsest first**;
/// level 0 is the coarsest.
pub struct Multigrid<E: SystemEntry = f64> {
    levels: Levels<E>,
    /// What each level holds, coarsest first.
    summaries: Vec<LevelSummary>,
    options: ResolvedOptions,
    setup_seconds: f64,
}

impl<E: SystemEntry> Multigrid<E> {
    /// Builds all levels.
    ///
    /// `matrix` is the finest, symmetric positive definite, of numbers or 3 × 3
    /// blocks. `prolongations` come **coarsest first**: the last leads to the rows of
    /// `matrix`, a number an entry, which acts on all components of a block alike. The
    /// levels below the last prolongation without columns do not count.
    ///
    /// # Errors
    /// [`Error::Size`] if a prolongation does not fit the level above it,
    /// [`Error::NotFinite`] or [`Error::Diagonal`] for a senseless matrix,
    /// [`Error::CoarsestSingular`] for a coarsest level that cannot be solved directly,
    /// [`Error::CoarsestTooLarge`] if aggregates stay so small that no level gets small
    /// enough, [`Error::Option`].
    pub fn new(
        matrix: &Csr<E>,
        prolongations: Vec<Csr<f64>>,
        options: &MultigridOptions,
    ) -> Result<Self, Error> {
        let unconstrained = vec![Vec::new(); prolongations.len() + 1];
        Self::constrained(matrix, prolongations, unconstrained, options)
    }

    /// As [`Multigrid::new`], with rows that are constrained in some directions.
    ///
    /// `projectors` has a list for each level, coarsest first, the finest included:
    /// (row, orthogonal projector Q onto its free directions), rows ascending. The
    /// matrix must be Q A Q + s (I − Q) with s > 0 there, and right-hand sides
    /// zero in the constrained directions. Corrections are prolonged by Q P Q.
    ///
    /// # Errors
    /// As [`Multigrid::new`], and [`Error::Projector`].
    pub fn constrained(
        matrix: &Csr<E>,
        prolongations: Vec<Csr<f64>>,
        projectors: Vec<Vec<(u32, E)>>,
        options: &MultigridOptions,
    ) -> Result<Self, Error> {
        let transfers = prolongations.into_iter().map(Transfer::from).collect();
        let below = NearNullSpace::Constants;
        Self::with_transfers(matrix, transfers, projectors, below, options)
    }

    /// As [`Multigrid::constrained`], with a choice for each transfer, and with the vectors
    /// that the levels `below` the coarsest of them carry.
    ///
    /// # Errors
    /// As [`Multigrid::constrained`]; [`Error::Size`], [`Error::NotFinite`] and
    /// [`Error::Option`] for rigid motions that do not fit.
    pub fn with_transfers(
        matrix: &Csr<E>,
        mut transfers: Vec<Transfer<E>>,
        mut projectors: Vec<Vec<(u32, E)>>,
        below: NearNullSpace,
        options: &MultigridOptions,
    ) -> Result<Self, Error> {
        let start = Instant::now();
        check_size("columns of the matrix", matrix.columns(), matrix.rows())?;
        check_size("lists of projectors", projectors.len(), transfers.len() + 1)?;
        check_finite("matrix", E::flat(matrix.values()))?;
        let options = options.resolved(E::SIZE > 1, contrast(matrix))?;
        // Levels are built from the finest down.
        transfers.reverse();
        projectors.reverse();
        let levels = E::build(matrix, transfers, projectors, below, &options)?;
        Ok(Self::of(levels, options, start))
    }

    fn of(levels: Levels<E>, options: ResolvedOptions, start: Instant) -> Self {
        let summaries = levels.summaries.iter().rev().cloned().collect();
        Self { levels, summaries, options, setup_seconds: start.elapsed().as_secs_f64() }
    }

    /// The multigrid of a matrix with other numbers in the same places, for instance
    /// after a change of material: to the last bit what building it anew gives.
    ///
    /// Whatever depends on places and prolongations alone is kept: patterns,
    /// transposes, colours and domains of rows, the elimination order of the coarsest level. A
    /// multigrid that fails is lost.
    ///
    /// # Errors
    /// [`Error::Pattern`] if the matrix has entries elsewhere; [`Error::Option`] if a
    /// prolongation was smoothed or a coarse matrix given, which belong to the old
    /// numbers; else as [`Multigrid::new`].
    pub fn updated(self, matrix: &Csr<E>) -> Result<Self, Error> {
        let start = Instant::now();
        let Self { levels, options, .. } = self;
        let levels = E::rebuild(levels, matrix, &options)?;
        Ok(Self::of(levels, options, start))
    }

    /// Full multigrid for A x = `rhs`: the coarsest given level is solved, directly or by ten
    /// cycles over the algebraic levels below it; on each finer one, `cycles` cycles improve the solution of the coarser.
    ///
    /// `transfers` bring solutions (not corrections) to the finer level, **coarsest
    /// first**, one for each prolongation; without any the prolongations do. Right-hand
    /// sides of coarser levels are Pᵀ times the finer one. Prescribed values other than
    /// zero need a smooth lift first: solve for what a smooth extension of them leaves.
    ///
    /// One cycle a level reaches the accuracy of the discretisation where a cycle
    /// reduces errors well and transfers are of higher order than prolongations.
    ///
    /// # Errors
    /// [`Error::Size`] if `rhs` or a transfer does not fit; [`Error::NotFinite`].
    pub fn full_multigrid(
        &mut self,
        rhs: &[E::Nodal],
        transfers: &[Csr<f64>],
        cycles: usize,
    ) -> Result<Vec<E::Nodal>, Error> {
        check_finite("right-hand side", Nodal::flat(rhs))?;
        let rows = |level: &LevelSummary| level.unknowns / E::SIZE;
        let rows: Vec<usize> = self.levels.summaries.iter().map(rows).collect();
        check_size("entries of the right-hand side", rhs.len(), rows[0])?;
        // Levels without unknowns have no transfer that could be used.
        let given = self.levels.given();
        let finest_first: Vec<&Csr<f64>> = transfers.iter().rev().take(given).collect();
        if !transfers.is_empty() {
            check_size("transfers of full multigrid", finest_first.len(), given)?;
        }
        for (transfer, sizes) in finest_first.iter().zip(rows.windows(2)) {
            check_size("rows of a transfer", transfer.rows(), sizes[0])?;
            check_size("columns of a transfer", transfer.columns(), sizes[1])?;
        }
        let mut x = vec![E::Nodal::default(); rhs.len()];
        let (r, z) = (Nodal::flat(rhs), Nodal::flat_mut(&mut x));
        E::full(&mut self.levels, r, &finest_first, cycles, z);
        Ok(x)
    }

    /// Measures each kernel of the cycle: bytes, seconds, and how they compare with
    /// copying memory, all medians of `repeats` interleaved runs. A W-cycle is
    /// measured level by level as if it were a V-cycle.
    pub fn traffic(&mut self, repeats: usize) -> Traffic {
        E::traffic(&mut self.levels, repeats)
    }

    /// The bytes that one cycle must move, from the sizes of its arrays, the direct solve
    /// left out. A W-cycle visits each level twice as often as the one above it.
    pub fn cycle_bytes(&self) -> usize {
        E::cycle_bytes(&self.levels, &self.options)
    }

    /// What each level holds, coarsest first.
    pub fn levels(&self) -> &[LevelSummary] {
        &self.summaries
    }

    /// How many levels lie below the given ones.
    pub fn algebraic_levels(&self) -> usize {
        self.summaries.len() - 1 - self.levels.given()
    }

    /// What the finest level holds.
    pub fn finest(&self) -> &LevelSummary {
        &self.levels.summaries[0]
    }

    /// The unknowns of all levels over those of the finest.
    pub fn grid_complexity(&self) -> f64 {
        self.over_finest(|level| level.unknowns)
    }

    /// The nonzeros of all matrices over those of the finest.
    pub fn operator_complexity(&self) -> f64 {
        self.over_finest(|level| level.nonzeros)
    }

    fn over_finest(&self, count: impl Fn(&LevelSummary) -> usize) -> f64 {
        let sum: usize = self.summaries.iter().map(&count).sum();
        sum as f64 / count(self.finest()).max(1) as f64
    }

    /// The memory of all levels, in bytes.
    pub fn bytes(&self) -> usize {
        self.summaries.iter().map(|level| level.bytes).sum()
    }

    /// The work of one cycle in products with the finest matrix: on each
    /// smoothed level the nonzeros times (smoothing products + 1 residual, unless
    /// sweeps leave it), and twice those of the prolongation. (The first Chebyshev step of a
    /// cycle is counted although, from zero, it needs no product.) A W-cycle
    /// visits each level twice as often as the one above it.
    pub fn work_units(&self) -> f64 {
        let passes = self.options.products();
        let smoothed = &self.levels.summaries[..self.summaries.len() - 1];
        let work = |(below, level): (usize, &LevelSummary)| {
            let visit = passes * level.nonzeros + 2 * level.prolongation_nonzeros.unwrap_or(0);
            self.options.visits(below) as f64 * visit as f64
        };
        let sum: f64 = smoothed.iter().enumerate().map(work).sum();
        sum / self.finest().nonzeros.max(1) as f64
    }

    /// The choices that it runs with.
    pub fn options(&self) -> &ResolvedOptions {
        &self.options
    }
}

/// The largest over the smallest entry of the diagonal, by their norms; at least 1.
fn contrast<E: SystemEntry>(matrix: &Csr<E>) -> f64 {
    let norms = matrix.diagonal().into_iter().map(|entry| entry.norm());
    let ends = norms.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), norm| {
        (low.min(norm), high.max(norm))
    });
    (ends.1 / ends.0).max(1.0)
}

impl<E: SystemEntry> Preconditioner<E::Nodal> for Multigrid<E> {
    fn apply(&mut self, r: &[E::Nodal], z: &mut [E::Nodal]) {
        E::cycle(&mut self.levels, Nodal::flat(r), Nodal::flat_mut(z));
    }

    fn setup_seconds(&self) -> f64 {
        self.setup_seconds
    }

    fn is_symmetric(&self) -> bool {
        self.options.is_symmetric()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::krylov::cg::conjugate_gradients;
    use crate::krylov::iteration::SolveOptions;
    use crate::krylov::stationary::mean_reduction;
    use crate::multigrid::options::{CycleShape, Precision, Smoother};
    use crate::sparse::noise::noise;
    use crate::toy::{interpolation, second_difference};

    /// The second difference on 2^`levels` − 1 points, down to one point.
    fn interval(levels: u32, options: &MultigridOptions) -> (Csr<f64>, Multigrid) {
        let points = |level: u32| (1usize << level) - 1;
        let matrix = second_difference(points(levels));
        let prolongations = (1..levels).map(|l| interpolation(points(l))).collect();
        let multigrid = Multigrid::new(&matrix, prolongations, options).unwrap();
        (matrix, multigrid)
    }

    #[test]
    fn the_reduction_on_an_interval_does_not_depend_on_the_level() {
        let double = MultigridOptions { precision: Some(Precision::Double), ..Default::default() };
        let gauss_seidel = MultigridOptions { smoother: Some(Smoother::GaussSeidel), ..double };
        for (options, bound) in [(double, 0.12), (gauss_seidel, 0.2)] {
            for levels in [4, 7, 10, 13] {
                let (matrix, mut multigrid) = interval(levels, &options);
                let reduction = mean_reduction(&matrix, &mut multigrid, 20).unwrap();
                assert!(reduction < bound, "{levels} levels: {reduction}");
            }
        }
    }

    #[test]
    fn the_cycle_is_symmetric() {
        let double = MultigridOptions { precision: Some(Precision::Double), ..Default::default() };
        // The last two with four domains on the finest level.
        for (smoother, shape, levels) in [
            (Smoother::GaussSeidel, CycleShape::V, 8),
            (Smoother::CHEBYSHEV, CycleShape::V, 8),
            (Smoother::HybridGaussSeidel, CycleShape::V, 14),
            (Smoother::HybridGaussSeidel, CycleShape::W, 14),
        ] {
            let options =
                MultigridOptions { smoother: Some(smoother), shape, before: 2, after: 2, ..double };
            let (matrix, mut multigrid) = interval(levels, &options);
            let [u, v] = [4, 5].map(|seed| noise(matrix.rows(), seed));
            let [mut mu, mut mv] = [u.clone(), v.clone()];
            multigrid.apply(&u, &mut mu);
            multigrid.apply(&v, &mut mv);
            let (left, right) = (crate::dot(&mu, &v), crate::dot(&u, &mv));
            let size = crate::norm(&mu) * crate::norm(&v);
            assert!((left - right).abs() < 1e-13 * size, "{left} {right}");
        }
    }

    #[test]
    fn single_precision_takes_the_same_iterations() {
        let double = MultigridOptions { precision: Some(Precision::Double), ..Default::default() };
        let goal = SolveOptions { tolerance: 1e-12, ..Default::default() };
        let iterations = [double, MultigridOptions::default()].map(|options| {
            let (matrix, mut multigrid) = interval(8, &options);
            let rhs = noise(matrix.rows(), 6);
            conjugate_gradients(&matrix, &rhs, &mut multigrid, &goal).unwrap().1.iterations
        });
        assert_eq!(iterations[0], iterations[1]);
    }

    #[test]
    fn units_do_not_change_the_iterations() {
        // Beyond the largest and below the smallest numbers of single precision.
        let iterations = [1e-46, 1.0, 1e39].map(|coefficient| {
            let a = second_difference(255);
            let a = a.with_values(a.values().iter().map(|v| coefficient * v).collect());
            let prolongations = [1, 3, 7, 15, 31, 63, 127].map(interpolation).into();
            let mut multigrid = Multigrid::new(&a, prolongations, &Default::default()).unwrap();
            let (rhs, goal) = (noise(255, 6), SolveOptions::default());
            conjugate_gradients(&a, &rhs, &mut multigrid, &goal).unwrap().1.iterations
        });
        assert_eq!(iterations, [iterations[1]; 3]);
    }

    #[test]
    fn the_table_adds_up() {
        let (matrix, multigrid) = interval(3, &MultigridOptions::default());
        let unknowns: Vec<usize> = multigrid.levels().iter().map(|l| l.unknowns).collect();
        let nonzeros: Vec<usize> = multigrid.levels().iter().map(|l| l.nonzeros).collect();
        assert_eq!((unknowns, nonzeros), (vec![1, 3, 7], vec![1, 7, 19]));
        assert_eq!(multigrid.grid_complexity(), 11.0 / 7.0);
        assert_eq!(multigrid.operator_complexity(), 27.0 / 19.0);
        // Seven passes over two smoothed levels, and P with 9 and 3 entries twice.
        assert_eq!(multigrid.work_units(), (7.0 * 26.0 + 2.0 * 12.0) / 19.0);
        let table = multigrid.to_string();
        assert_eq!(table.lines().count(), 5);
        assert!(table.contains("direct") && table.contains("operator complexity 1.421"));
        assert_eq!(matrix.rows(), 7);
    }

    #[test]
    fn senseless_input_is_refused() {
        let a = second_difference(7);
        let new = |matrix: &Csr<f64>, p: Vec<Csr<f64>>| {
            Multigrid::new(matrix, p, &MultigridOptions::default())
        };
        let not_fitting = new(&a, vec![interpolation(4)]);
        assert!(matches!(not_fitting, Err(Error::Size { found: 9, expected: 7, .. })));
        let negative = a.with_values(a.values().iter().map(|v| -v).collect());
        let refused = new(&negative, vec![]);
        assert!(matches!(refused, Err(Error::Diagonal { level: 0, row: 0, value: -2.0 })));
        let mut values = a.values().to_vec();
        values[5] = f64::NAN;
        let refused = new(&a.with_values(values), vec![]);
        assert!(matches!(refused, Err(Error::NotFinite { index: 5, .. })));
        let no_sweeps = MultigridOptions { before: 0, after: 0, ..Default::default() };
        assert!(matches!(Multigrid::new(&a, vec![], &no_sweeps), Err(Error::Option { .. })));
    }

    #[test]
    fn a_level_without_unknowns_ends_the_list() {
        let empty = Csr::new(0, vec![0; 4], vec![], vec![]).unwrap();
        let prolongations = vec![empty, interpolation(3)];
        let a = second_difference(7);
        let multigrid = Multigrid::new(&a, prolongations, &Default::default()).unwrap();
        assert_eq!(multigrid.levels().len(), 2);
    }
}
