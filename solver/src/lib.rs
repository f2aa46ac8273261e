//! Sparse matrices, Krylov methods and geometric multigrid: algebra alone, no mesh.
//!
//! ```text
//! matrix, prolongations ──Multigrid──▶ conjugate_gradients ──▶ solution, SolveReport
//! ```
//!
//! Matrices are [`Csr`]: `u32` columns, entries that are numbers or 3 × 3 blocks, double
//! precision outside, single precision inside the cycle; all loops are parallel over
//! fixed chunks of rows, so results have the same bits for any number of threads. Errors
//! are values ([`Error`]) and carry what was reached.
//!
//! ```
//! use octruss_solver::*;
//!
//! // −u″ = 1 on 7 points between two fixed ends, and the 3 in between as coarse level.
//! let row = |i: u32| (i.saturating_sub(1)..7.min(i + 2)).map(move |j| (i, j));
//! let entries: Vec<(u32, u32)> = (0..7).flat_map(row).collect();
//! let offsets = (0..=7).map(|i| entries.partition_point(|e| e.0 < i)).collect();
//! let values = entries.iter().map(|(i, j)| if i == j { 2.0 } else { -1.0 }).collect();
//! let matrix = Csr::new(7, offsets, entries.iter().map(|e| e.1).collect(), values)?;
//! let (columns, weights) = (vec![0, 0, 0, 1, 1, 1, 2, 2, 2], [0.5, 1.0, 0.5].repeat(3));
//! let prolongation = Csr::new(3, vec![0, 1, 2, 4, 5, 7, 8, 9], columns, weights)?;
//!
//! let mut multigrid = Multigrid::new(&matrix, vec![prolongation], &Default::default())?;
//! let rhs = vec![1.0 / 64.0; 7];
//! let (x, report) =
//!     conjugate_gradients(&matrix, &rhs, &mut multigrid, &SolveOptions::default())?;
//! assert!(report.relative_residual <= 1e-8);
//! assert!((x[3] - 0.125).abs() < 1e-8);
//! # Ok::<(), Error>(())
//! ```

mod choices;
mod error;
mod krylov;
mod multigrid;
mod report;
mod sparse;
#[cfg(test)]
mod toy;

pub use error::{Error, check_finite, check_size};
pub use krylov::cg::conjugate_gradients;
pub use krylov::iteration::{EachIteration, SolveOptions};
pub use krylov::operator::Operator;
pub use krylov::preconditioner::{Identity, Preconditioner};
pub use krylov::row_sums::WithRowSums;
pub use krylov::stationary::{geometric_mean, mean_reduction, reductions, stationary_iteration};
pub use multigrid::aggregation::near_null_space::NearNullSpace;
pub use multigrid::figures::summary::{LevelOrigin, LevelSummary};
pub use multigrid::figures::traffic::{KernelTraffic, Traffic};
pub use multigrid::galerkin::galerkin;
pub use multigrid::options::{
    CycleShape, DiagonalKind, MultigridOptions, Precision, ResolvedOptions, Smoother,
};
pub use multigrid::projectors::project;
pub use multigrid::setup::Multigrid;
pub use multigrid::system_entry::SystemEntry;
pub use multigrid::transfer::Transfer;
pub use report::{Ended, SolveReport, Unfinished};
pub use sparse::backward_error::backward_error;
pub use sparse::csr::Csr;
pub use sparse::dot::{dot, norm};
pub use sparse::entry::{Acts, Entry, Nodal};
pub use sparse::kernels;
pub use sparse::multiply::multiply;
pub use sparse::noise::noise;
pub use sparse::real::Real;
pub use sparse::rows::build_rows;
pub use sparse::transpose::transpose;
