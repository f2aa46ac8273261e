//! Finite elements on hierarchies of tetrahedral meshes.
//!
//! ```text
//! Hierarchy, Problem ──▶ Discretisation ──▶ Solver ──▶ Solution ──▶ strains, forces, errors
//! ```
//!
//! A [`Problem`] is [`Poisson`], [`Biharmonic`] or [`Elasticity`]; [`Discretisation`] assembles
//! it on the finest level and solves it by multigrid over all levels. Whoever wants the parts
//! finds them, too: [`assemble`], [`restrict_to_free`], and the multigrid of `octruss-solver`.
//!
//! ```
//! use octruss_fem::{Discretisation, Options, Poisson};
//! use octruss_mesh::{FeatureOptions, Hierarchy, Scheme, shapes::kuhn_cube};
//!
//! let mut hierarchy = Hierarchy::new(kuhn_cube(4), &FeatureOptions::default());
//! hierarchy.subdivide(Scheme::Linear)?;
//! let problem = Poisson {
//!     source: 1.0.into(),
//!     fixed: (1..=6).map(|side| (side, 0.0.into())).collect(),
//!     ..Poisson::default()
//! };
//! let options = Options::default();
//! let solution = Discretisation::new(&hierarchy, &problem, &options)?.solve(&options)?;
//! assert!(solution.report.relative_residual <= 1e-8);
//! // The middle of a unit cube with unit source is at 0.0562; this mesh is coarse.
//! let middle = solution.values.into_iter().fold(0.0, f64::max);
//! assert!((middle - 0.0562).abs() < 0.003);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assemble;
mod boundary;
mod discretisation;
mod element;
mod error;
mod free;
mod lift;
mod options;
mod problem;
mod recovery;
mod reference;
mod rigid_mode;
mod rigid_motion;
mod transfer;

pub use assemble::biharmonic::assemble_biharmonic;
pub use assemble::elasticity::{VectorSystem, assemble_elasticity};
pub use assemble::poisson::{System, assemble};
pub use boundary::constraints::Constraints;
pub use boundary::dofs::Dofs;
pub use boundary::held_vertex::HeldVertex;
pub use boundary::level_unknowns::LevelUnknowns;
pub use boundary::locking::{Ridge, curved_supports, ridges};
pub use discretisation::discretise::Discretisation;
pub use discretisation::problem::{Assembled, Constrained, Problem};
pub use discretisation::solution::Solution;
pub use discretisation::solver::Solver;
pub use discretisation::transfers::TransferSummary;
pub use discretisation::unknown::Unknown;
pub use element::quadrature;
pub use error::Error;
pub use free::balance::{Balance, Balancing};
pub use free::free_bodies::FreeBodies;
pub use lift::smooth_lift;
pub use options::choices::{CoarseOperator, Cycle, FullTransfer, Method};
pub use options::prolongations::{ProlongationKind, Prolongations};
pub use options::solving::{Contradiction, Options};
pub use options::sweeps::Sweeps;
pub use problem::biharmonic::Biharmonic;
pub use problem::by_region::ByRegion;
pub use problem::elasticity::{Elasticity, Held, Material, Stiffness, Support, Vector, vector};
pub use problem::free::Free;
pub use problem::poisson::{Poisson, Robin};
pub use problem::scalar::{Function, Scalar};
pub use recovery::forces::Forces;
pub use recovery::nodal::Recovery;
pub use recovery::norms::{h1_seminorm_error, l2_error};
pub use recovery::stress::{equivalent_stresses, strains, stresses, von_mises};
pub use reference::difference::Difference;
pub use rigid_mode::RigidMode;
pub use transfer::restrict_to_free;
