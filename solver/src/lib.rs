//! From a mesh hierarchy to a solved system: P1 finite elements and geometric
//! multigrid.
//!
//! ```text
//! TetMesh, Poisson ──assemble──▶ System ─┐          (Elasticity ──assemble_elasticity──▶ VectorSystem)
//! SubdivisionMatrix ──restrict_to_free──▶│──Multigrid──▶ conjugate_gradients ──▶ solution, SolveReport
//! ```
//!
//! [`Multigrid`] knows matrices only, no mesh. Matrices are [`Csr`]: `u32`
//! columns, entries that are numbers or 3 × 3 blocks, double precision outside, single precision inside the cycle; all
//! loops are parallel over fixed chunks of rows, so results have the same bits
//! for any number of threads. Errors are values ([`Error`]) and carry what was
//! reached.
//!
//! ```
//! use octruss_mesh::{Topology, linear_matrix, shapes::kuhn_cube};
//! use octruss_solver::*;
//!
//! let mesh = kuhn_cube(8);
//! let problem = Poisson {
//!     source: 1.0.into(),
//!     fixed: (1..=6).map(|side| (side, 0.0.into())).collect(),
//!     ..Poisson::default()
//! };
//! let system = assemble(&mesh, &Topology::new(mesh.raw()), &problem)?;
//! let mut multigrid = Multigrid::new(&system.matrix, vec![], &MultigridOptions::default())?;
//! let (x, report) =
//!     conjugate_gradients(&system.matrix, &system.rhs, &mut multigrid, &SolveOptions::default())?;
//! assert!(report.relative_residual <= 1e-8);
//! // The middle of a unit cube with unit source is at 0.0562; this mesh is coarse.
//! let middle = system.expand(&x)?.into_iter().fold(0.0, f64::max);
//! assert!((middle - 0.0562).abs() < 0.003);
//! # Ok::<(), octruss_solver::Error>(())
//! ```

mod account;
mod accumulator;
mod ancestors;
mod assemble;
mod assemble_elasticity;
mod biharmonic;
mod blame;
mod blocks;
mod by_region;
mod cg;
mod chebyshev;
mod chunks;
mod coarse;
mod colouring;
mod constraints;
mod csr;
mod cycle;
mod diagonal;
mod dofs;
mod domain_rows;
mod domains;
mod dot;
mod edge_rows;
mod elasticity;
mod elasticity_load;
mod element;
mod entry;
mod error;
mod forces;
mod foundation;
mod galerkin;
mod gauss_seidel;
mod held_vertex;
mod hybrid_gauss_seidel;
pub mod kernels;
mod known;
mod level;
mod lift;
mod load;
mod matrix3;
mod multigrid;
mod multiply;
mod norms;
mod options;
mod pattern;
mod poisson_load;
mod preconditioner;
mod problem;
mod projectors;
pub mod quadrature;
mod random;
mod real;
mod recovery;
mod report;
mod rigid_modes;
mod row_smoothing;
mod rows;
mod run;
mod scalar;
mod scatter;
mod smoothed;
mod smoothing;
mod spectrum;
mod stationary;
mod stress;
mod summary;
mod surface;
mod symmetric;
#[cfg(test)]
mod toy;
mod transfer;
mod transpose;
mod two_parents;
mod weights;
mod workspaces;

pub use account::{Account, KernelTraffic};
pub use assemble::{System, assemble};
pub use assemble_elasticity::{VectorSystem, assemble_elasticity};
pub use biharmonic::{Biharmonic, assemble_biharmonic};
pub use by_region::ByRegion;
pub use cg::conjugate_gradients;
pub use constraints::Constraints;
pub use csr::Csr;
pub use dofs::Dofs;
pub use dot::{dot, norm};
pub use elasticity::{Elasticity, Held, Material, Stiffness, Support, Vector, vector};
pub use entry::{Acts, Entry, Nodal};
pub use error::Error;
pub use forces::Forces;
pub use galerkin::galerkin;
pub use held_vertex::HeldVertex;
pub use lift::{LevelUnknowns, smooth_lift};
pub use multigrid::Multigrid;
pub use multiply::multiply;
pub use norms::{h1_seminorm_error, l2_error};
pub use options::{CycleShape, DiagonalKind, MultigridOptions, Precision, Smoother};
pub use preconditioner::{Identity, Preconditioner};
pub use problem::{Poisson, Robin};
pub use random::noise;
pub use real::Real;
pub use recovery::Recovery;
pub use report::{SolveReport, Unfinished};
pub use rigid_modes::RigidMode;
pub use run::{Progress, SolveOptions};
pub use scalar::{Function, Scalar};
pub use stationary::{geometric_mean, mean_reduction, reductions, stationary_iteration};
pub use stress::{strains, stresses, von_mises};
pub use summary::LevelSummary;
pub use transfer::{Transfer, restrict_to_free};
pub use transpose::transpose;
