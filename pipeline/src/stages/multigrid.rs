//! One solve with one prolongation, and its figures.

use std::time::Instant;

use octruss_fem::Error;
use octruss_fem::{Dofs, LevelUnknowns};
use octruss_mesh::{Hierarchy, TetMesh};
use octruss_solver::{Csr, Entry, Multigrid, Nodal, SolveOptions};
use serde::Serialize;

use super::Context;
use super::method::MethodFigures;
use super::solve::Solve;
use super::traffic::{REPEATS, TrafficFigures};
use super::transfers::{Made, TransferFigures, reassemble, transfer_figures, transfers};
use crate::observer::Event;
use crate::recipe::{Choice, Prolongations};

/// What one solve took and reached.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolveFigures {
    /// By which expectations call it: the prolongation.
    pub name: String,
    /// What prolongs; if the finest transfer is apart, `FINEST/COARSER`.
    pub prolongation: String,
    /// Which rows were made exact for linear functions.
    pub affine_correction: &'static str,
    /// What rows on interfaces read.
    pub interface_rows: &'static str,
    /// Where coarse matrices come from.
    pub coarse_operator: &'static str,
    /// What it was done with.
    #[serde(flatten)]
    pub method: MethodFigures,
    /// Free unknowns on the finest level.
    pub unknowns: usize,
    /// How many levels the cycle has.
    pub levels: usize,
    /// Stored entries of the finest matrix.
    pub nonzeros: usize,
    /// Stored entries of all levels' matrices.
    pub nonzeros_all_levels: usize,
    /// Those over these: all levels over the finest.
    pub operator_complexity: f64,
    /// Unknowns of all levels over those of the finest.
    pub grid_complexity: f64,
    /// For each transfer, the coarsest first, how far it misses linear functions,
    /// in mean edge lengths.
    pub affine_defects: Vec<f64>,
    /// More about each transfer, the coarsest first.
    pub transfers: Vec<TransferFigures>,
    /// ‖b − A x‖ / ‖b‖ after the pass of full multigrid, before the first iteration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub full_multigrid_residual: Option<f64>,
    /// Iterations, one cycle each.
    pub iterations: usize,
    /// ‖b − A x‖ / ‖b‖ at the end.
    pub relative_residual: f64,
    /// Relative residuals from that of the start (1 of zero) on, one more than
    /// iterations.
    pub residual_history: Vec<f64>,
    /// The factor by which an iteration reduces the residual, geometric mean.
    pub mean_reduction: f64,
    /// Work for a decimal digit of the residual, in products with the finest
    /// matrix: a cycle and the product of the iteration itself.
    pub work_per_digit: f64,
    /// The least value at a vertex of a tet, of displacements their length.
    pub minimum: f64,
    /// The greatest value at a vertex of a tet, of displacements their length.
    pub maximum: f64,
    /// Prolongations, Galerkin products, factors; coarse matrices that are re-assembled
    /// count as assembly.
    pub setup_seconds: f64,
    /// Iterating, after the pass of full multigrid if there was one.
    pub solve_seconds: f64,
    /// Bytes and bandwidth of each kernel of a cycle, if asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub account: Option<TrafficFigures>,
}

impl SolveFigures {
    /// The outcome in a few words.
    pub fn result(&self) -> String {
        format!("{} iterations, residual {:.1e}", self.iterations, self.relative_residual)
    }
}

/// A problem on the finest level, and the unknowns of all.
pub struct Discrete<E: Entry> {
    /// One row for each unknown.
    pub matrix: Csr<E>,
    /// One entry for each unknown.
    pub rhs: Vec<E::Nodal>,
    /// The unknowns of each level, coarsest first.
    pub levels: Vec<LevelUnknowns<E>>,
    /// The matrices assembled on the coarse levels, coarsest first, where asked for.
    pub coarse_matrices: Vec<Csr<E>>,
    /// The time that assembling them took.
    pub coarse_seconds: f64,
    /// The solution of the coarsest level's own problem, where full multigrid needs
    /// one.
    pub coarsest: Option<Vec<E::Nodal>>,
}

impl<E: Entry> AsRef<Self> for Discrete<E> {
    fn as_ref(&self) -> &Self {
        self
    }
}

impl<E: Entry> Discrete<E> {
    /// The unknowns of the finest level.
    pub fn finest(&self) -> &Dofs {
        &self.levels.last().expect("there is at least one level").dofs
    }

    /// The projectors of each level, finest first.
    fn projectors(&self) -> Vec<Vec<(u32, E)>> {
        self.levels.iter().rev().map(|level| level.projectors.clone()).collect()
    }

    /// Leaves of values at the unknowns of the finest level what is in free directions.
    pub fn project(&self, x: &mut [E::Nodal]) {
        for (row, projector) in self.levels.iter().next_back().iter().flat_map(|l| &l.projectors) {
            let free = &mut x[*row as usize];
            *free = projector.add_product(*free, E::Nodal::default());
        }
    }

    /// How many numbers are unknown.
    pub fn unknowns(&self) -> usize {
        E::SIZE * self.finest().unknowns()
    }
}

/// The multigrid of an assembled problem as the keys ask for it, and what it was made
/// from, coarsest first.
///
/// # Errors
/// Whatever the solver reports.
pub fn set_up<'h, E: Entry<Real = f64>>(
    options: &Solve,
    prolongations: Prolongations,
    hierarchy: &'h Hierarchy,
    discrete: &Discrete<E>,
) -> Result<(Multigrid<E>, Vec<Made<'h>>), Error> {
    let which = options.transfer_options(prolongations);
    let (mut transfers, made) = transfers(&which, hierarchy, &discrete.levels)?;
    if options.reassembles() {
        reassemble(&mut transfers, &discrete.coarse_matrices);
    }
    let (projectors, cycle) = (discrete.projectors(), options.multigrid_options());
    let multigrid = Multigrid::with_transfers(&discrete.matrix, transfers, projectors, &cycle)?;
    Ok((multigrid, made))
}

/// Solves an assembled problem; the unknowns, and figures of which `minimum` and
/// `maximum` are still 0.
///
/// # Errors
/// Whatever the solver reports.
pub fn solve_with<E: Entry<Real = f64>>(
    options: &Solve,
    prolongations: Prolongations,
    hierarchy: &Hierarchy,
    discrete: &Discrete<E>,
    context: &Context,
) -> Result<(Vec<E::Nodal>, SolveFigures), Error> {
    let start = Instant::now();
    let Discrete { matrix, rhs, .. } = discrete;
    let (mut multigrid, made) = set_up(options, prolongations, hierarchy, discrete)?;
    let setup_seconds = start.elapsed().as_secs_f64();
    let figures_of_transfers = transfer_figures(hierarchy, &made);
    drop(made);
    let start = Instant::now();
    let transfer = options.full_transfer(hierarchy);
    let full_pass = transfer
        .map(|transfer| transfer.full_pass(hierarchy, discrete, &mut multigrid))
        .transpose()?;
    let pass_seconds = start.elapsed().as_secs_f64();
    let tell = |iteration: usize, residual: f64| {
        context.tell(Event::Note(format!("iteration {iteration}, residual {residual:.1e}")));
        context.go_on()
    };
    let stop = SolveOptions {
        start: full_pass.as_deref().map(Nodal::flat),
        tolerance: options.tolerance.0,
        max_iterations: options.max_iterations,
        progress: Some(&tell),
    };
    let (x, report) = options.iterate((matrix, rhs), &mut multigrid, &stop)?;
    let account = options.account.then(|| multigrid.traffic(REPEATS).into());
    let cycles = report.iterations as f64;
    // Without an iteration nothing was reduced, and nothing done.
    let first_residual = report.residual_history[0];
    let reduced = if cycles > 0.0 { report.relative_residual / first_residual } else { 1.0 };
    let work = cycles * (multigrid.work_units() + 1.0);
    let figures = SolveFigures {
        name: prolongations.to_string(),
        prolongation: prolongations.to_string(),
        affine_correction: options.affine_correction.0.name(),
        interface_rows: options.interface_rows.0.name(),
        coarse_operator: options.coarse_operator.0.name(),
        method: options.method_figures(&multigrid, transfer),
        unknowns: discrete.unknowns(),
        levels: multigrid.levels().len(),
        nonzeros: multigrid.levels()[0].nonzeros,
        nonzeros_all_levels: multigrid.levels().iter().map(|level| level.nonzeros).sum(),
        operator_complexity: multigrid.operator_complexity(),
        grid_complexity: multigrid.grid_complexity(),
        affine_defects: figures_of_transfers.iter().map(|t| t.affine_defect).collect(),
        transfers: figures_of_transfers,
        full_multigrid_residual: full_pass.is_some().then_some(first_residual),
        iterations: report.iterations,
        relative_residual: report.relative_residual,
        residual_history: report.residual_history,
        mean_reduction: reduced.powf(1.0 / cycles.max(1.0)),
        work_per_digit: if cycles > 0.0 { -work / reduced.log10() } else { 0.0 },
        minimum: 0.0,
        maximum: 0.0,
        setup_seconds,
        solve_seconds: pass_seconds + report.solve_seconds,
        account,
    };
    Ok((x, figures))
}

/// The least and the greatest value; NaN is passed over.
pub fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, greatest], value| {
        [least.min(value), greatest.max(value)]
    })
}

/// Puts `blank`, NaN, which viewers leave blank, where no tet is and nothing was
/// solved.
pub fn blank_outside<T: Copy>(solution: &mut [T], mesh: &TetMesh, blank: T) {
    let mut inside = vec![false; solution.len()];
    mesh.tets().as_flattened().iter().for_each(|&v| inside[v as usize] = true);
    for (value, _) in solution.iter_mut().zip(inside).filter(|(_, inside)| !inside) {
        *value = blank;
    }
}
