//! Levels from the finest down, one after the other: given ones first, then algebraic
//! ones, until a direct solution is cheap.

use crate::error::Error;
use crate::multigrid::aggregation::candidates::Candidates;
use crate::multigrid::aggregation::coarsening::{Coarsened, Coarsening};
use crate::multigrid::coarse::{CoarseSolver, Elimination, LARGEST, affordable_elimination};
use crate::multigrid::cycle::{Coarsest, Cycle};
use crate::multigrid::figures::summary::{LevelOrigin, LevelSummary};
use crate::multigrid::galerkin::galerkin_of_entries;
use crate::multigrid::level::{Kept, Level};
use crate::multigrid::options::{ResolvedOptions, Smoother};
use crate::multigrid::projectors::Projectors;
use crate::multigrid::smoother::diagonal::Diagonal;
use crate::multigrid::smoother::domains::Domains;
use crate::multigrid::smoother::level_smoother::Grouping;
use crate::multigrid::weights::Weights;
use crate::sparse::blocks::expand_blocks;
use crate::sparse::csr::Csr;
use crate::sparse::dot::largest;
use crate::sparse::entry::{Entry, Nodal};
use crate::sparse::real::Real;
use std::borrow::Cow;

/// A direct solution is cheap if its factor has at most this share of the numbers of the
/// finest matrix: two solutions with it then cost less than half a sweep there.
const AFFORDABLE: f64 = 0.25;

/// The levels so far, and the matrix of the one that comes next.
pub(crate) struct Descent<'m, E: Entry, F: Entry> {
    levels: Vec<Level<F>>,
    summaries: Vec<LevelSummary>,
    pub(crate) current: Cow<'m, Csr<E>>,
    pub(crate) diagonal: Diagonal<E>,
    origin: LevelOrigin,
    /// How many levels are given below the current one, the number that it is called by.
    below: usize,
    /// All matrices of the cycle are this times those of the problem.
    scale: f64,
    options: &'m ResolvedOptions,
    finest_rows: usize,
    /// So many entries may a factor have.
    affordable: usize,
}

impl<'m, E: Entry<Real = f64>, F: Entry> Descent<'m, E, F> {
    /// Begins with the finest matrix; `given` transfers lead down from it.
    pub(crate) fn new(
        matrix: &'m Csr<E>,
        given: usize,
        options: &'m ResolvedOptions,
    ) -> Result<Self, Error> {
        let diagonal = Diagonal::new(matrix, given)?;
        let scale = scale_to_one(E::flat(&diagonal.entries));
        let numbers = matrix.nonzeros() * E::SIZE * E::SIZE;
        Ok(Self {
            levels: Vec::new(),
            summaries: Vec::new(),
            current: Cow::Borrowed(matrix),
            diagonal,
            origin: LevelOrigin::Given,
            below: given,
            scale,
            options,
            finest_rows: matrix.rows(),
            affordable: (AFFORDABLE * numbers as f64) as usize,
        })
    }

    /// The matrix of the next level with its diagonal.
    ///
    /// # Errors
    /// [`Error::Diagonal`].
    pub(crate) fn with_diagonal(&self, coarser: Csr<E>) -> Result<(Csr<E>, Diagonal<E>), Error> {
        let diagonal = Diagonal::new(&coarser, self.below.saturating_sub(1))?;
        Ok((coarser, diagonal))
    }

    /// Makes the current matrix a level and goes on with a coarser one.
    pub(crate) fn step(
        &mut self,
        kept: Kept<F>,
        (coarser, coarse_diagonal): (Csr<E>, Diagonal<E>),
        both: [&Projectors<E>; 2],
        coarser_origin: LevelOrigin,
    ) {
        self.below = self.below.saturating_sub(1);
        let diagonal = std::mem::replace(&mut self.diagonal, coarse_diagonal);
        let scaled = (&*self.current, diagonal, self.scale);
        let level = Level::<F>::new(scaled, kept, both, self.options);
        self.summaries.push(LevelSummary {
            origin: self.origin,
            bytes: level.bytes(),
            prolongation_nonzeros: Some(level.prolongation.multiplications()),
            largest_eigenvalue: level.smoothing.largest_eigenvalue(),
            ..LevelSummary::of(&*self.current)
        });
        self.levels.push(level);
        self.current = Cow::Owned(coarser);
        self.origin = coarser_origin;
    }

    /// Adds algebraic levels below the last given one until a direct solution is cheap or
    /// levels hardly shrink any more.
    pub(crate) fn below_the_given(
        &mut self,
        candidates: Candidates<E>,
        projectors: &Projectors<E>,
    ) -> Result<Option<Elimination>, Error> {
        let mut coarsening = Coarsening::new(candidates, self.current.rows());
        let mut made_here: Option<Projectors<E>> = None;
        loop {
            let elimination = self.elimination();
            if elimination.is_some() {
                return Ok(elimination);
            }
            let fine = made_here.as_ref().unwrap_or(projectors);
            let Some(made) = coarsening.step((&self.current, &mut self.diagonal), fine) else {
                return Ok(None);
            };
            let Coarsened { prolongation, projectors: coarse } = made;
            let coarser = galerkin_of_entries(&self.current, &prolongation, &coarse);
            // What is left of a stiff part's rigid motions may be rounding: the direct solver
            // then says which.
            let Ok(coarser) = self.with_diagonal(coarser) else { return Ok(None) };
            let rounded = prolongation.cast();
            drop(prolongation);
            let mut kept = Kept::new(Weights::Entries(rounded));
            if self.options.smoother == Smoother::HybridGaussSeidel {
                // Rows are numbered as they lie, aggregates by their first vertices.
                let domains = Domains::new(self.current.rows(), |row| Some(vec![row as u32]));
                kept.grouping = Some(Grouping::Domains(domains));
            }
            self.step(kept, coarser, [fine, &coarse], LevelOrigin::Algebraic);
            made_here = Some(coarse);
        }
    }

    /// Lets a direct solution count as cheap wherever it is possible.
    pub(crate) fn afford_any_factor(&mut self) {
        self.affordable = usize::MAX;
    }

    /// That of the current matrix, if a direct solution is cheap.
    fn elimination(&self) -> Option<Elimination> {
        let unknowns = self.current.rows() * E::SIZE;
        let numbers = || expand_blocks(&self.current, self.scale);
        (unknowns <= LARGEST).then(|| affordable_elimination(&numbers(), self.affordable))?
    }

    /// Solves the current matrix directly.
    pub(crate) fn finish(
        mut self,
        elimination: Option<Elimination>,
    ) -> Result<(Cycle<F>, Vec<LevelSummary>), Error> {
        let solver = CoarseSolver::new(expand_blocks(&self.current, self.scale), elimination)
            .map_err(|error| self.with_null_vector_on_the_finest(error))?;
        self.summaries.push(LevelSummary {
            origin: self.origin,
            bytes: solver.bytes(),
            ..LevelSummary::of(&*self.current)
        });
        let coarsest = Coarsest::new(solver, self.current.rows() * E::SIZE);
        let shape = self.options.shape;
        let cycle = Cycle::new(self.finest_rows, self.levels, coarsest, shape, self.scale);
        Ok((cycle, self.summaries))
    }
}

impl<E: Entry<Real = f64>, F: Entry> Descent<'_, E, F> {
    /// What the coarsest matrix sends to zero, prolonged: only there do rows mean something
    /// to who reads the error.
    fn with_null_vector_on_the_finest(&self, mut error: Error) -> Error {
        if let Error::CoarsestSingular { null_vector, .. } = &mut error
            && !null_vector.is_empty()
        {
            let mut x = F::Nodal::from_flat(null_vector);
            for level in self.levels.iter().rev() {
                x = level.transfer(None, &x);
            }
            *null_vector = F::Nodal::flat(&x).iter().map(|number| number.to_f64()).collect();
        }
        error
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
