//! A problem on all levels of a hierarchy.

use crate::boundary::level_unknowns::LevelUnknowns;
use crate::discretisation::problem::{Assembled, Problem};
use crate::discretisation::unknown::Unknown;
use crate::error::Error;
use crate::free::free_bodies::{FreeBodies, projected};
use crate::options::choices::Cycle;
use crate::options::prolongations::Prolongations;
use crate::options::solving::Options;
use crate::reference::difference::Difference;
use octruss_mesh::{Hierarchy, Level};
use octruss_solver::{Csr, Multigrid, NearNullSpace, Nodal, SolveOptions, conjugate_gradients};
use std::time::Instant;

/// A problem on a hierarchy: the matrix and the right-hand side of the finest level, and
/// the unknowns of all.
///
/// ```
/// use octruss_fem::{Discretisation, Options, Poisson};
/// use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, shapes::kuhn_cube};
///
/// let mut hierarchy = Hierarchy::new(kuhn_cube(2), &FeatureOptions::default());
/// hierarchy.subdivide(Scheme::Linear)?;
/// hierarchy.subdivide(Scheme::Linear)?;
/// let problem = Poisson {
///     source: 1.0.into(),
///     fixed: (1..=6).map(|side| (side, 0.0.into())).collect(),
///     ..Poisson::default()
/// };
/// let options = Options::default();
/// let solution = Discretisation::new(&hierarchy, &problem, &options)?.solve(&options)?;
/// // The middle of a unit cube with unit source is at 0.0562; this mesh is coarse.
/// let middle = solution.values.into_iter().fold(0.0, f64::max);
/// assert!((middle - 0.0562).abs() < 0.003);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Discretisation<'h, E: Unknown = f64> {
    /// The levels.
    pub hierarchy: &'h Hierarchy,
    /// One row for each free unknown of the finest level.
    pub matrix: Csr<E>,
    /// The sum of each of its rows, where that is known better than its entries tell.
    pub row_sums: Option<Vec<E>>,
    /// One entry for each free unknown of the finest level.
    pub rhs: Vec<E::Nodal>,
    /// Which unknowns of the finest level are free, and what the others are.
    pub constraints: E::Constraints,
    /// The problem that is solved in place of this one, for what the solution differs by
    /// from a constant or a rigid motion, where values are prescribed far from zero.
    pub difference: Option<Difference<E::Nodal>>,
    /// The parts that nothing holds, if the problem balances their loads: `matrix` is
    /// singular.
    pub free: Option<FreeBodies<E::Nodal>>,
    /// The unknowns of each level, coarsest first.
    pub levels: Vec<LevelUnknowns<E>>,
    /// The matrices assembled on the coarse levels, coarsest first, where asked for.
    pub coarse_matrices: Vec<Csr<E>>,
    /// The time that assembling them took.
    pub reassembly_seconds: f64,
    /// What the levels below the coarsest mesh with unknowns carry: what has no energy where
    /// nothing is held.
    pub near_null_space: NearNullSpace,
    /// What prolongs where options leave it open.
    pub usual_prolongation: Prolongations,
    /// The solution of the coarsest level's own problem, where full multigrid needs
    /// one: with it the lift of prescribed values begins.
    pub(crate) coarsest: Option<Vec<E::Nodal>>,
    /// What the problem lacks, if nothing acts.
    missing_load: Option<&'static str>,
}

impl<'h, E: Unknown> Discretisation<'h, E> {
    /// Assembles a problem on the finest level, and of the coarser ones what the options
    /// need: matrices if they are to be re-assembled, a solution if full multigrid is to
    /// lift prescribed values.
    ///
    /// # Errors
    /// [`Error`] tells what is wrong with the data of the problem.
    pub fn new<P: Problem<Entry = E>>(
        hierarchy: &'h Hierarchy,
        problem: &P,
        options: &Options,
    ) -> Result<Self, Error> {
        let (finest, coarser) = hierarchy.levels().split_last().expect("at least one level");
        let (mut levels, mut coarse_matrices, mut seconds) = (Vec::new(), Vec::new(), 0.0);
        for level in coarser {
            levels.push(E::level(&problem.constraints(level)?));
            if options.reassembles() {
                let start = Instant::now();
                coarse_matrices.push(problem.assemble(level)?.regularised().into_owned());
                seconds += start.elapsed().as_secs_f64();
            }
        }
        let Assembled { matrix, row_sums, rhs, constraints, difference, free } =
            problem.assemble(finest)?;
        levels.push(E::level(&constraints));
        let missing_load = is_without_load(&rhs, &levels).then(|| problem.missing_load());
        // Levels without unknowns do not count.
        let without = levels.iter().rposition(|level| level.dofs.unknowns() == 0);
        let coarsest = without.map_or(0, |last| (last + 1).min(coarser.len()));
        let below = near_null_space(problem, &hierarchy.levels()[coarsest], &levels[coarsest]);
        // Assembled anew even where its matrix is at hand: only here is its load wanted.
        let lifts =
            options.cycle() == Cycle::Full && !levels.iter().all(LevelUnknowns::is_homogeneous);
        let coarsest = lifts
            .then(|| {
                let coarsest = hierarchy.coarsest();
                let below = near_null_space(problem, coarsest, &levels[0]);
                let projectors = levels[0].projectors.clone();
                solve_coarsest(problem.assemble(coarsest)?, (projectors, below), options)
            })
            .transpose()?;
        let reassembly_seconds = seconds;
        Ok(Self {
            hierarchy,
            matrix,
            row_sums,
            rhs,
            constraints,
            difference,
            free,
            levels,
            coarse_matrices,
            reassembly_seconds,
            near_null_space: below,
            usual_prolongation: problem.usual_prolongation(hierarchy),
            coarsest,
            missing_load,
        })
    }

    /// Checks that something acts on what is free, or that a value other than 0 is prescribed:
    /// solving refuses what else has the solution 0.
    ///
    /// # Errors
    /// [`Error::NoLoad`].
    pub fn check_loaded(&self) -> Result<(), Error> {
        self.missing_load.map_or(Ok(()), |missing| Err(Error::NoLoad { missing }))
    }

    /// The unknowns of the finest level.
    ///
    /// # Panics
    /// Never: there is at least one level.
    pub fn finest(&self) -> &LevelUnknowns<E> {
        self.levels.last().expect("there is at least one level")
    }

    /// How many numbers are unknown.
    pub fn unknowns(&self) -> usize {
        E::SIZE * self.finest().dofs.unknowns()
    }

    /// A value for each vertex of the finest level from the unknowns.
    ///
    /// # Errors
    /// [`octruss_solver::Error::Size`] unless there is one `x` for each unknown.
    pub fn expand(&self, x: &[E::Nodal]) -> Result<Vec<E::Nodal>, Error> {
        E::expand(&self.constraints, x)
    }

    /// Leaves of values at the unknowns of the finest level what is in free directions.
    pub fn project(&self, x: &mut [E::Nodal]) {
        octruss_solver::project(&self.finest().projectors, x);
    }
}

/// Whether nothing acts and nothing is prescribed: all of the solution is 0, and most likely
/// something was forgotten.
fn is_without_load<E: Unknown>(rhs: &[E::Nodal], levels: &[LevelUnknowns<E>]) -> bool {
    let acts = Nodal::flat(rhs).iter().any(|value| *value != 0.0);
    let is_prescribed = !levels.iter().all(LevelUnknowns::is_homogeneous);
    !(acts || is_prescribed || rhs.is_empty())
}

fn near_null_space<P: Problem>(
    problem: &P,
    level: &Level,
    unknowns: &LevelUnknowns<P::Entry>,
) -> NearNullSpace {
    let position = |&vertex: &u32| level.mesh.points()[vertex as usize];
    problem.near_null_space(unknowns.dofs.free().iter().map(position).collect())
}

/// The solution on the coarsest mesh.
fn solve_coarsest<E: Unknown>(
    system: Assembled<E>,
    (projectors, below): (Vec<(u32, E)>, NearNullSpace),
    options: &Options,
) -> Result<Vec<E::Nodal>, Error> {
    let projectors = vec![projectors];
    let cycle = options.multigrid();
    let regularised = system.regularised();
    let mut multigrid =
        Multigrid::with_transfers(&regularised, Vec::new(), projectors, below, &cycle)?;
    drop(regularised);
    let Assembled { matrix, rhs, constraints, difference, free, .. } = system;
    let solved = difference.as_ref().map_or(&rhs, |difference| &difference.rhs);
    let (x, _) = projected(free.as_ref(), &mut multigrid, |cycle| {
        conjugate_gradients(&matrix, solved, cycle, &SolveOptions::default())
    })?;
    Ok(measured_from_zero(difference.as_ref(), &E::level(&constraints), x))
}

/// The unknowns of a problem from those of the difference that was solved for, if one was.
pub(crate) fn measured_from_zero<E: Unknown>(
    difference: Option<&Difference<E::Nodal>>,
    level: &LevelUnknowns<E>,
    mut x: Vec<E::Nodal>,
) -> Vec<E::Nodal> {
    if let Some(difference) = difference {
        let mut reference = difference.at_unknowns(level.dofs.free());
        octruss_solver::project(&level.projectors, &mut reference);
        x.iter_mut().zip(&reference).for_each(|(x, reference)| *x = x.plus(*reference));
    }
    x
}
