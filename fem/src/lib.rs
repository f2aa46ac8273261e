//! Finite elements on hierarchies of tetrahedral meshes.
//!
//! ```text
//! TetMesh, Poisson ──assemble──▶ System            (Elasticity ──assemble_elasticity──▶ VectorSystem)
//! SubdivisionMatrix ──restrict_to_free──▶ prolongation of octruss_solver::Multigrid
//! ```
//!
//! ```
//! use octruss_fem::{Poisson, assemble};
//! use octruss_mesh::{Topology, shapes::kuhn_cube};
//! use octruss_solver::{Multigrid, MultigridOptions, SolveOptions, conjugate_gradients};
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
//! # Ok::<(), octruss_fem::Error>(())
//! ```

mod assemble;
mod boundary;
mod discretisation;
mod element;
mod error;
mod lift;
mod options;
mod problem;
mod recovery;
mod rigid_mode;
mod transfer;

pub use assemble::biharmonic::assemble_biharmonic;
pub use assemble::elasticity::{VectorSystem, assemble_elasticity};
pub use assemble::poisson::{System, assemble};
pub use boundary::constraints::Constraints;
pub use boundary::dofs::Dofs;
pub use boundary::held_vertex::HeldVertex;
pub use boundary::level_unknowns::LevelUnknowns;
pub use discretisation::discretise::Discretisation;
pub use discretisation::problem::{Assembled, Constrained, Problem};
pub use discretisation::solution::Solution;
pub use discretisation::solver::Solver;
pub use discretisation::transfers::TransferSummary;
pub use discretisation::unknown::Unknown;
pub use element::quadrature;
pub use error::Error;
pub use lift::smooth_lift;
pub use options::choices::{CoarseOperator, Cycle, FullTransfer, Method};
pub use options::prolongations::{ProlongationKind, Prolongations};
pub use options::solving::Options;
pub use options::sweeps::Sweeps;
pub use problem::biharmonic::Biharmonic;
pub use problem::by_region::ByRegion;
pub use problem::elasticity::{Elasticity, Held, Material, Stiffness, Support, Vector, vector};
pub use problem::poisson::{Poisson, Robin};
pub use problem::scalar::{Function, Scalar};
pub use recovery::forces::Forces;
pub use recovery::nodal::Recovery;
pub use recovery::norms::{h1_seminorm_error, l2_error};
pub use recovery::stress::{strains, stresses, von_mises};
pub use rigid_mode::RigidMode;
pub use transfer::restrict_to_free;
